// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The box of a packing: a cube (square) with a hard wall or a periodic boundary on each axis.
#pragma once

#include "particles/particle_set.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace packing {

// [0, edge] on each axis.
struct Container {
  int dimension = 3;
  double edge = 1;
  std::array<bool, 3> periodic{};

  // The place inside the box of a coordinate that has just been moved: wrapped, or not farther than the wall allows a
  // sphere of this radius.
  double keep(int axis, double x, double radius) const {
    if (periodic[static_cast<size_t>(axis)]) {
      const double wrapped = x - edge * std::floor(x / edge);
      return wrapped < edge ? wrapped : 0;  // a tiny negative x rounds to the edge itself
    }
    if (x < radius) return radius;
    return x > edge - radius ? edge - radius : x;
  }

  // The component of a distance that is the nearest image's.
  double nearest(int axis, double difference) const {
    if (!periodic[static_cast<size_t>(axis)]) return difference;
    return difference - edge * std::floor(difference / edge + 0.5);
  }

  // An empty set of particles in this box.
  particles::ParticleSet empty_set() const {
    particles::ParticleSet set;
    set.dimension = dimension;
    set.has_box = true;
    for (int k = 0; k < dimension; k++) {
      set.box_max[k] = edge;
      set.periodic[k] = periodic[static_cast<size_t>(k)] ? 1 : 0;
    }
    return set;
  }
};

}  // namespace packing
