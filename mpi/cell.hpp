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
  // What to add to a distance for all roundings that images of one box within `reach` of the other go through.
  double slack(const Box &box, const Box &other, double reach) const;
  // Calls of(n, offset) for each image of `box`, moved by n[0..2] edges and so by offset[0..2], that may be within
  // `reach` of the other along each axis. False, and no call of use, if they are too many to look at.
  template <class Of>
  bool for_images(const Box &box, const Box &other, double reach, Of &&of) const;

 private:
  struct Range {
    double first;
    int count;  // -1: too many
  };
  Range images_along(int axis, const Box &box, double offset, const Box &other, double reach) const;

  int dimension_;
  bool periodic_[3] = {false, false, false};
  double edges_[3][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};  // a, b, c: each leads along no axis beyond its own
  double low_[3] = {0, 0, 0};
  double scale_[3] = {0, 0, 0};  // of the numbers that an edge was made of
};

template <class Of>
bool Cell::for_images(const Box &box, const Box &other, double reach, Of &&of) const {
  // From the last axis on, whose edge also leads along those before it.
  const Range third = images_along(2, box, 0, other, reach);
  if (third.count < 0) return false;
  for (int k = 0; k < third.count; k++) {
    double n[3] = {0, 0, third.first + k}, offset[3] = {0, 0, 0};
    (void)shift(offset, 2, n[2]);
    const double after_third[2] = {offset[0], offset[1]};
    const Range second = images_along(1, box, offset[1], other, reach);
    if (second.count < 0) return false;
    for (int j = 0; j < second.count; j++) {
      n[1] = second.first + j;
      offset[0] = after_third[0];
      offset[1] = after_third[1];
      (void)shift(offset, 1, n[1]);
      const double after_second = offset[0];
      const Range first = images_along(0, box, offset[0], other, reach);
      if (first.count < 0) return false;
      for (int i = 0; i < first.count; i++) {
        n[0] = first.first + i;
        offset[0] = after_second;
        (void)shift(offset, 0, n[0]);
        of(n, offset);
      }
    }
  }
  return true;
}

}  // namespace hgrid::mpi
