// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The pairs of each step, from the library.
#pragma once

#include "dem/setup/setup.hpp"

#include <hgrid/hgrid.hpp>

#include <cstddef>

namespace dem {

using PairView = hgrid::View<hg_pair>;

// Pairs come ascending, (a, b) with a < b: their order, and so every sum of forces, depends on nothing but the
// positions, not on threads, skin, or what the grid has seen before.
class ContactSearch {
 public:
  explicit ContactSearch(const Setup &setup);

  // The pairs of particles at `centers` [count][dimension] that are within reach of each other; `radii` null if they
  // have not changed. `offset` is how far the images above have moved along x (shear): the tilt of the periodic cell.
  // The result lasts until the next call.
  PairView find(const double *centers, const double *radii, double offset);

  hg_grid_stats stats() const { return grid_.get_stats(); }

 private:
  hg_grid_def def_;
  hgrid::Grid grid_;
  size_t count_;
  bool sheared_;
};

}  // namespace dem
