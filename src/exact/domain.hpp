// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The space that particles live in: which axes are periodic, and where a position lies in the box.
#pragma once

#include <cmath>
#include <cstdint>

namespace hg {

// A particle may lie this many box lengths outside a periodic axis: up to there, wrapping is off by less than
// 3 * 2^-33 box lengths, less than half the resolution of the search (space/fixed_point.hpp).
inline constexpr double kMaxWraps = 1048576.0;  // 2^20

// How many box lengths a place `above` the low face of a periodic axis lies above the box: 0 in the box, -1 below its
// low face. Next to the box that is a matter of comparing, whatever the host's rounding mode makes of a quotient.
// Kernels of all instruction sets compile their own copy, hence `static`.
static inline double boxes_above(double above, double length) {
  if (above < -length || above >= 2 * length) return std::floor(above / length);
  return above < 0 ? -1 : (above < length ? 0 : 1);
}

// The place of x above `low` on a periodic axis of that length, in [0, length]. Going back to absolute coordinates
// would lose digits in a box far from the origin.
static inline double place_in_box(double x, double low, double length) {
  const double above = x - low;
  const double inside = above - boxes_above(above, length) * length;
  return inside < 0 ? 0 : (inside > length ? length : inside);
}

// The same without a division, for x at most one box length outside the box.
static inline double near_place_in_box(double x, double low, double length) {
  const double above = x - low;
  return above + (above < 0 ? length : (above < length ? 0 : -length));
}
// True if all x in [least, greatest] are that near.
static inline bool are_near_box(double least, double greatest, double low, double length) {
  return least - low >= -length && greatest - low < 2 * length;
}

struct Domain {
  int dimension = 3;
  bool any_periodic = false;
  bool periodic[3] = {false, false, false};
  double box_min[3] = {0, 0, 0};
  double box_max[3] = {0, 0, 0};
  double length[3] = {0, 0, 0};  // box_max - box_min, rounded; 0 where no box is given

  // How many box lengths x lies above the box: x - wraps * length is in it but for rounding.
  double wraps(int axis, double x) const {
    if (!periodic[axis]) return 0;
    return boxes_above(x - box_min[axis], length[axis]);
  }

  // Where the search sees x: on periodic axes its place in the box.
  double position(int axis, double x) const {
    return periodic[axis] ? place_in_box(x, box_min[axis], length[axis]) : x;
  }
};

// Which periodic image of a particle is meant: per axis -1, 0 or +1 box lengths, packed in base 3.
using Image = uint8_t;
inline constexpr Image kNoImage = 13;  // (0, 0, 0)
inline constexpr Image kImages = 27;

inline Image make_image(int x, int y, int z) { return static_cast<Image>((x + 1) + 3 * (y + 1) + 9 * (z + 1)); }
inline int image_step(Image image, int axis) {
  const int divisor = axis == 0 ? 1 : (axis == 1 ? 3 : 9);
  return image / divisor % 3 - 1;
}

// Images as bits. Forward are those whose step is positive on the last axis with a step.
using ImageSet = int32_t;
inline constexpr ImageSet kBackwardImages = (1 << kNoImage) - 1;
inline constexpr ImageSet kForwardImages = kBackwardImages << (kNoImage + 1);
// By axis and step + 1. A digit has the three steps along x, three digits those along y.
inline constexpr ImageSet kImagesWithStep[3][3] = {
    {0111111111, 0222222222, 0444444444}, {0007007007, 0070070070, 0700700700}, {0000000777, 0000777000, 0777000000}};

}  // namespace hg
