// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The cells of one level, and the map from coordinates to them. Lengths are in quanta (fixed_point.hpp).
#pragma once

#include <cstddef>
#include <cstdint>

namespace hg {

// What a search must allow for: coordinates are floored (1), wrapped and shifted across the box (2.5), converted to
// float (64 each) and compared with row borders computed in float (256). docs/theory/exactness.md, section 6, adds this
// up.
inline constexpr float kSearchSlack = 1024.0f;
inline constexpr float kSearchScale = 1.0f + 0x1p-20f;

// Kernels read up to so many elements behind the end of the last cell, ignoring what they read there.
inline constexpr size_t kCellPadding = 32;

// Rows along x, stacked in y and z. Cell c of row (y, z) begins at cell_begin[(z * count[1] + y) * count[0] + c] in the
// sorted particles, and ends where the next cell begins.
struct CellTable {
  int32_t count[3];
  float width[3];
  float inverse_width[3];
  float largest_radius;  // folded, of the particles on the level
  const uint32_t *cell_begin;
};

namespace {

// The greatest value that cell_of turns into a cell.
inline float last_of(const CellTable &cells, int axis) { return static_cast<float>(cells.count[axis]) - 0.5f; }

// Eq. 1 on one axis: the one map from coordinates to cells, for particles and for the ends of searches alike. Every
// step is monotone, so a particle inside a search box is never in a cell outside the box's cells
// (docs/theory/exactness.md, section 6). V wraps the vectors of an instruction set.
template <class V>
typename V::Int cell_of(typename V::Float x, typename V::Float inverse_width, typename V::Float last) {
  return V::truncate(V::min(V::max(V::mul(x, inverse_width), V::set(0.0f)), last));
}

}  // namespace
}  // namespace hg
