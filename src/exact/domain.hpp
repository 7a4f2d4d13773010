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

// The place of x above `low` on a periodic axis of that length, in [0, length]. Going back to absolute coordinates
// would lose digits in a box far from the origin. Kernels of all instruction sets compile their own copy, hence
// `static`.
static inline double place_in_box(double x, double low, double length) {
  const double above = x - low;
  const double inside = above - std::floor(above / length) * length;
  return inside < 0 ? 0 : (inside > length ? length : inside);
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
    return std::floor((x - box_min[axis]) / length[axis]);
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

}  // namespace hg
