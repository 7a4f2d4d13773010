// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The periodic cell as far as the choice of ghosts needs it: in doubles, with room for every rounding, as what is
// chosen too much costs a little and what is missed is a fault. The core decides on pairs exactly.
#pragma once

#include <hgrid/types.h>

namespace hgrid::mpi {

// A box of centres, with what the largest number that went into a bound was.
struct Box {
  double low[3], high[3];
  double scale;
};

class Cell {
 public:
  explicit Cell(const hg_grid_def &def);

  int dimension() const { return dimension_; }
  bool is_periodic(int axis) const { return periodic_[axis]; }
  double length(int axis) const { return edges_[axis][axis]; }
  double low(int axis) const { return low_[axis]; }

  // Adds n times the edge of a periodic axis to a place; returns how large the numbers were.
  double shift(double *place, int axis, double n) const;
  // An upper bound of how far `to` is from the image of `from` that is about nearest to it.
  double distance_moved(const double *from, const double *to) const;
  // False only if no image of the place is within `reach` of the box.
  bool may_reach(const Box &box, const double *place, double reach) const;

 private:
  bool may_reach(const Box &box, const double *place, double reach, double rest, int axis) const;

  int dimension_;
  bool periodic_[3] = {false, false, false};
  double edges_[3][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};  // a, b, c: each leads along no axis beyond its own
  double low_[3] = {0, 0, 0};
  double scale_[3] = {0, 0, 0};  // of the numbers that an edge was made of
};

}  // namespace hgrid::mpi
