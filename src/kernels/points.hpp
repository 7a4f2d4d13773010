// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles in fixed point (space/fixed_point.hpp), as the kernels see them. Radii are folded (exact/interaction.hpp)
// and in quanta.
#pragma once

#include "src/exact/domain.hpp"

#include <cstddef>
#include <cstdint>

namespace hg {

// Kernels read and write this many elements beyond the end of arrays, ignoring what they read there.
inline constexpr size_t kPadding = 16;

// Sorted by level, row and cell, with kPadding readable elements behind.
struct PointArrays {
  const int32_t *x, *y, *z;  // z is not read in 2D
  const float *radius;
  const uint32_t *slot;
  const Image *image;             // which periodic image the points stand for; NULL: kNoImage, all of them
  const int32_t *body = nullptr;  // of which they are parts, negative: of none; NULL: all of none
};

// The same while they are made.
struct PointColumns {
  int32_t *x, *y, *z;  // z is not written in 2D
  float *radius;
  uint32_t *slot;
};

static inline const int32_t *coordinates(const PointArrays &points, int axis) {
  return axis == 0 ? points.x : (axis == 1 ? points.y : points.z);
}

// One of them, in one load of 16 bytes.
struct Point {
  int32_t x, y, z;
  float radius;
};

}  // namespace hg
