// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The box of a packing, [0, edge] on each axis, with hard walls or periodic boundaries.
#pragma once

#include "packing/vector.hpp"
#include "particles/particle_set.hpp"

#include <hgrid/hgrid.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace packing {

class Box {
 public:
  Box(int dimension, const Vector &edge, const std::array<bool, 3> &periodic)
      : dimension_(dimension), edge_(edge), periodic_(periodic) {
    for (int axis = 0; axis < 3; axis++) {
      if (axis >= dimension) periodic_[static_cast<size_t>(axis)] = false;
      half_[axis] = is_periodic(axis) ? edge[axis] / 2 : std::numeric_limits<double>::infinity();
    }
  }

  int dimension() const { return dimension_; }
  double edge(int axis) const { return edge_[axis]; }
  bool is_periodic(int axis) const { return periodic_[static_cast<size_t>(axis)]; }
  bool any_periodic() const { return periodic_[0] || periodic_[1] || periodic_[2]; }
  bool any_wall() const { return !periodic_[0] || !periodic_[1] || (dimension_ == 3 && !periodic_[2]); }

  double volume() const { return dimension_ == 2 ? edge_[0] * edge_[1] : edge_[0] * edge_[1] * edge_[2]; }

  // The nearest image of the difference of two places that are less than 3/2 edges apart.
  double nearest(int axis, double difference) const {
    const double shift = difference > half_[axis] ? -edge_[axis] : difference < -half_[axis] ? edge_[axis] : 0.0;
    return difference + shift;
  }
  Vector nearest(const Vector &difference) const {
    return {nearest(0, difference[0]), nearest(1, difference[1]), nearest(2, difference[2])};
  }

  // The image of a place in [0, edge) on periodic axes.
  void wrap(Vector &place) const {
    for (int axis = 0; axis < dimension_; axis++)
      if (is_periodic(axis)) place[axis] = wrapped(axis, place[axis]);
  }

  // The place inside the box of a coordinate that has just been moved: wrapped, or not farther than the wall allows a
  // sphere of this radius.
  double keep(int axis, double x, double radius) const {
    if (is_periodic(axis)) return wrapped(axis, x);
    if (x < radius) return radius;
    return x > edge_[axis] - radius ? edge_[axis] - radius : x;
  }

  // Copies the box into the definition of a grid.
  void describe(hg_grid_def &def) const {
    def.dimension = dimension_;
    for (int axis = 0; axis < dimension_; axis++) {
      def.box_max[axis] = edge_[axis];
      def.periodic[axis] = is_periodic(axis) ? 1 : 0;
    }
  }

  // An empty set of particles in this box.
  particles::ParticleSet empty_set() const {
    particles::ParticleSet set;
    set.dimension = dimension_;
    set.has_box = true;
    for (int axis = 0; axis < dimension_; axis++) {
      set.box_max[axis] = edge_[axis];
      set.periodic[axis] = is_periodic(axis) ? 1 : 0;
    }
    return set;
  }

 private:
  double wrapped(int axis, double x) const {
    const double edge = edge_[axis];
    if (x >= 0 && x < edge) return x;
    const double inside = x - edge * std::floor(x / edge);
    return inside < edge ? inside : 0;  // a tiny negative x rounds to the edge itself
  }

  int dimension_;
  Vector edge_, half_;
  std::array<bool, 3> periodic_;
};

}  // namespace packing
