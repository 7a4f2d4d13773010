// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Fixed-point coordinates: integers of 2^-30 of the system's extent, called quanta. Their differences are exact, they
// need half the memory of doubles, and what they cannot decide is decided on the doubles. docs/theory/exactness.md,
// sections 3 and 4, proves how far off they are.
#pragma once

#include "src/exact/domain.hpp"
#include "src/space/bounds.hpp"

#include <cstdint>

namespace hg {

inline constexpr double kFixedPointQuanta =
    1073741824.0;  // 2^30, so that differences and periodic shifts fit in 32 bits

// The map from a position (Domain::position) to its coordinate, in two steps. `static`, as the kernels of each
// instruction set compile their own copy.
static inline double to_quanta(double position, double half_origin, double scale) {
  return (0.5 * position - half_origin) * (2 * scale);
}
// The integer below, kept within [low, low + span]. Counted from `low` all are positive, so that cutting digits off
// rounds down.
static inline int32_t floor_within(double quanta, double low, double span) {
  const double above = quanta - low;
  const double positive = above > 0 ? above : 0.0;
  return static_cast<int32_t>(positive < span ? positive : span) + static_cast<int32_t>(low);
}

// Plain numbers, for the kernels too.
struct FixedPoint {
  double scale = 1;                   // quanta per length: a power of two, so scaling rounds nothing
  double half_origin[3] = {0, 0, 0};  // half the position of coordinate 0; halves, so that differences are finite
  double extent[3] = {0, 0, 0};       // in quanta
  double box_min[3] = {0, 0, 0};
  double length[3] = {0, 0, 0};   // of the box; 0 on open axes
  int32_t period[3] = {0, 0, 0};  // the same in quanta, rounded

  // `least_extent`: a length that must be well resolved even if the centres coincide; finite.
  static FixedPoint over(const Bounds &bounds, const Domain &domain, double least_extent);

  double quanta(int axis, double position) const { return to_quanta(position, half_origin[axis], scale); }
  // Of a centre within the bounds: at most one quantum off.
  int32_t coordinate(int axis, double center) const {
    const double position = length[axis] > 0 ? place_in_box(center, box_min[axis], length[axis]) : center;
    return floor_within(quanta(axis, position), 0, kFixedPointQuanta - 1);
  }
};

}  // namespace hg
