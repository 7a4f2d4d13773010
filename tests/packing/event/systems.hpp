// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Small systems of growing spheres, and what is measured of them without the library.
#pragma once

#include "packing/box.hpp"
#include "packing/event/engine.hpp"
#include "packing/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace event_test {

// Points (scale 0) with radii 1 to `ratio` and masses 1 to 3 in a cube that they fill to `density` at scale 1.
struct Points {
  packing::Box box;
  packing::event::State state;
};

inline Points random_points(size_t count, int dimension, std::array<bool, 3> periodic, double ratio, double density,
                            uint64_t seed) {
  packing::Random random(seed);
  packing::event::State state;
  state.scale = 0;
  double volume = 0;
  for (size_t i = 0; i < count; i++) {
    const double r = 1 + (ratio - 1) * random.uniform();
    state.radii.push_back(r);
    state.masses.push_back(1 + 2 * random.uniform());
    volume += dimension == 2 ? M_PI * r * r : 4 * M_PI / 3 * r * r * r;
  }
  const double edge = std::pow(volume / density, 1.0 / dimension);
  for (size_t i = 0; i < count; i++) {
    packing::Vector center = packing::Vector::Zero(), velocity = packing::Vector::Zero();
    for (int k = 0; k < dimension; k++) {
      center[k] = edge * random.uniform();
      velocity[k] = random.normal();
    }
    state.centers.push_back(center);
    state.velocities.push_back(velocity);
  }
  return {packing::Box(dimension, packing::Vector::Constant(edge), periodic), state};
}

// The smallest gap between two surfaces or a surface and a wall, all pairs compared; negative: an overlap.
inline double smallest_gap(const packing::Box &box, const packing::event::State &state) {
  double smallest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < state.count(); i++) {
    const double r = state.scale * state.radii[i];
    for (int k = 0; k < box.dimension(); k++) {
      const double x = state.centers[i][k];
      if (!box.is_periodic(k)) smallest = std::min({smallest, x - r, box.edge(k) - x - r});
    }
    for (size_t j = 0; j < i; j++) {
      double square = 0;
      for (int k = 0; k < box.dimension(); k++) {
        double x = state.centers[i][k] - state.centers[j][k];
        if (box.is_periodic(k)) x = std::remainder(x, box.edge(k));
        square += x * x;
      }
      smallest = std::min(smallest, std::sqrt(square) - r - state.scale * state.radii[j]);
    }
  }
  return smallest;
}

}  // namespace event_test
