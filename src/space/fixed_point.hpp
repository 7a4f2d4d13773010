// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Fixed-point coordinates: integers of 2^-30 of the system's extent, called quanta. Their differences are exact, they
// need half the memory of doubles, and what they cannot decide is decided on the doubles. docs/theory/exactness.md,
// sections 3 and 4, proves how far off they are.
#pragma once

#include "src/exact/domain.hpp"
#include "src/space/bounds.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>

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

// Whole quanta as doubles, for 0 <= quanta < 2^51: rounded to an integer, its bits, and the lowest 32 of them.
static inline double to_whole(double quanta) { return (quanta + 0x1p52) - 0x1p52; }
static inline uint64_t whole_bits(double whole) {
  const double with_mark = whole + 0x1p52;
  uint64_t bits = 0;
  std::memcpy(&bits, &with_mark, sizeof bits);
  return bits & ((uint64_t{1} << 52) - 1);
}
static inline int32_t low_word(double whole) { return static_cast<int32_t>(static_cast<uint32_t>(whole_bits(whole))); }

// Of coordinates that wrap, of points that are near.
static inline int32_t near_difference(int32_t x, int32_t y) {
  return static_cast<int32_t>(static_cast<uint32_t>(x) - static_cast<uint32_t>(y));
}

// Wrapping, as the coordinates of such a map do.
static inline int32_t moved_by(int32_t x, int step, int32_t period) {
  return static_cast<int32_t>(static_cast<uint32_t>(x) + static_cast<uint32_t>(step) * static_cast<uint32_t>(period));
}

// The period, -1, 0 or 1 times, that brings a particle back to the image nearest to where it was.
static inline double boxes_back(double moved, double period) {
  return moved > 0.5 * period ? -1.0 : (moved < -0.5 * period ? 1.0 : 0.0);
}

// The same where it may take several.
static inline double edges_back(double moved, double period) { return -std::floor(moved / period + 0.5); }

// Plain numbers, for the kernels too.
struct FixedPoint {
  double scale = 1;                   // quanta per length: a power of two, so scaling rounds nothing
  double half_origin[3] = {0, 0, 0};  // half the position of coordinate 0; halves, so that differences are finite
  double extent[3] = {0, 0, 0};       // in quanta
  double box_min[3] = {0, 0, 0};
  double length[3] = {0, 0, 0};   // of the box; 0 on open axes
  double tilt[3] = {0, 0, 0};     // as in Domain
  bool tilted = false;            // one of them is not 0
  int32_t period[3] = {0, 0, 0};  // the lengths in quanta, rounded

  // `least_extent`: a length that must be well resolved even if the centres coincide; finite.
  static FixedPoint over(const Bounds &bounds, const Domain &domain, double least_extent);

  // For a space that is mostly empty: coordinates are the lowest 32 bits of places up to 2^46 quanta, fine enough for
  // particles of diameter `largest` to be 2^26 quanta wide if the extents allow it. Differences of near points are
  // exact; points that are not near must not be compared. Particles lie up to `most_wraps` boxes outside a periodic
  // box.
  static FixedPoint wrapping(const Bounds &bounds, const Domain &domain, double largest, double most_wraps);

  // The cell is another one from now on; the scale and the box that coordinates are counted from stay.
  void set_cell(const Domain &domain);

  double quanta(int axis, double position) const { return to_quanta(position, half_origin[axis], scale); }
  // Of a centre: where it lies in the box.
  void find_quanta(const double *center, int dimension, double *quanta_of) const {
    double boxes[3];
    for (int axis = 0; axis < dimension; axis++) quanta_of[axis] = center[axis] - box_min[axis];
    take_into_box(quanta_of, boxes, length, tilt, dimension);
    for (int axis = 0; axis < dimension; axis++) quanta_of[axis] = quanta(axis, quanta_of[axis]);
  }
  // Of a centre within the bounds: at most one quantum off.
  void find_coordinates(const double *center, int dimension, int32_t *x) const {
    double quanta_of[3];
    find_quanta(center, dimension, quanta_of);
    for (int axis = 0; axis < dimension; axis++) x[axis] = floor_within(quanta_of[axis], 0, kFixedPointQuanta - 1);
  }
  // Of a map that wraps: whole quanta, of which the coordinates are the lowest 32 bits.
  void find_place(const double *center, int dimension, double *place) const {
    find_quanta(center, dimension, place);
    for (int axis = 0; axis < dimension; axis++) place[axis] = to_whole(place[axis]);
  }
  // Of a map that wraps: a period as a place, of which period[axis] are the lowest 32 bits.
  double period_place(int axis) const { return to_whole(length[axis] * scale); }

 private:
  void set_axes(const Bounds &bounds, const Domain &domain);
};

}  // namespace hg
