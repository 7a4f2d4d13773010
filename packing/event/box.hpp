// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The box of a simulation, [0, edge] on each axis, with hard walls or periodic boundaries.
#pragma once

#include "packing/event/vector.hpp"

#include <hgrid/hgrid.h>

#include <array>
#include <cmath>
#include <limits>

namespace packing {

class Box {
 public:
  Box(int dimension, const Vector &edge, const std::array<bool, 3> &periodic)
      : dimension_(dimension), edge_(edge), periodic_(periodic) {
    for (int k = 0; k < 3; k++) {
      if (k >= dimension) periodic_[static_cast<size_t>(k)] = false;
      half_[k] = is_periodic(k) ? edge[k] / 2 : std::numeric_limits<double>::infinity();
    }
  }

  int dimension() const { return dimension_; }
  double edge(int axis) const { return edge_[axis]; }
  bool is_periodic(int axis) const { return periodic_[static_cast<size_t>(axis)]; }
  bool any_periodic() const { return periodic_[0] || periodic_[1] || periodic_[2]; }

  double volume() const { return dimension_ == 2 ? edge_[0] * edge_[1] : edge_[0] * edge_[1] * edge_[2]; }

  // The nearest image of the difference of two places that are less than 3/2 edges apart.
  Vector nearest(Vector difference) const {
    for (int k = 0; k < 3; k++) {
      const double d = difference[k];
      const double shift = d > half_[k] ? -edge_[k] : d < -half_[k] ? edge_[k] : 0.0;
      difference[k] = d + shift;
    }
    return difference;
  }

  // The image of a place in [0, edge) on periodic axes.
  void wrap(Vector &place) const {
    for (int k = 0; k < dimension_; k++) {
      if (!is_periodic(k) || (place[k] >= 0 && place[k] < edge_[k])) continue;
      place[k] -= edge_[k] * std::floor(place[k] / edge_[k]);
      if (!(place[k] < edge_[k])) place[k] = 0;  // a tiny negative place rounds to the edge itself
    }
  }

  // Copies the box into the definition of a grid.
  void describe(hg_grid_def &def) const {
    def.dimension = dimension_;
    for (int k = 0; k < dimension_; k++) {
      def.box_max[k] = edge_[k];
      def.periodic[k] = is_periodic(k) ? 1 : 0;
    }
  }

 private:
  int dimension_;
  Vector edge_, half_;
  std::array<bool, 3> periodic_;
};

}  // namespace packing
