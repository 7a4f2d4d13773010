// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Takes blocks of positions into the periodic box, one source for all instruction sets.
#pragma once

#include "src/base/interval.hpp"
#include "src/exact/domain.hpp"
#include "src/space/fixed_point.hpp"

#include <cstddef>

namespace hg {
namespace {

// On one axis; all positions of the system are within `extent`. Divisions would be a fifth of the time of building, and
// few systems leave their box by more than its length.
template <size_t Count>
void wrap_block(double (&position)[Count], double low, double length, const Interval &extent) {
  if (are_near_box(extent.least, extent.greatest, low, length)) {
    for (size_t i = 0; i < Count; i++) position[i] = near_place_in_box(position[i], low, length);
  } else {
    for (size_t i = 0; i < Count; i++) position[i] = place_in_box(position[i], low, length);
  }
}

// take_into_box on the axes from `first` on, where a cell is tilted.
template <int D, size_t Count>
void take_block_into_box(double (&position)[3][Count], int first, const FixedPoint &map) {
  double boxes[3][Count];
  for (int axis = D - 1; axis >= first; axis--) {
    const double low = map.box_min[axis], length = map.length[axis];
    double(&above)[Count] = position[axis];
    double(&taken)[Count] = boxes[axis];
    for (double &x : above) x -= low;
    for (int higher = D - 1; higher > axis; higher--) {
      const double tilt = map.tilt[kTiltOf[higher][axis]];
      for (size_t i = 0; i < Count; i++) above[i] -= boxes[higher][i] * tilt;
    }
    for (size_t i = 0; i < Count; i++) taken[i] = length > 0 ? boxes_above(above[i], length) : 0;
    if (!(length > 0)) continue;
    for (size_t i = 0; i < Count; i++) above[i] = cut_to_box(above[i] - taken[i] * length, length);
  }
}

// Positions on the axes from `first` on become places in the box; on open axes they stay.
template <int D, size_t Count>
void wrap_from(int first, double (&position)[3][Count], const FixedPoint &map, const Interval *extent) {
  if (map.tilted) {
    take_block_into_box<D>(position, first, map);
    return;
  }
  for (int axis = first; axis < D; axis++) {
    if (map.length[axis] > 0) wrap_block(position[axis], map.box_min[axis], map.length[axis], extent[axis]);
  }
}

}  // namespace
}  // namespace hg
