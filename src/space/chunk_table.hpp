// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The cells of one level in a space that is mostly empty: rows along x as in cell_table.hpp, cut into chunks of 8
// cells, of which only those that hold particles are stored. Lengths are in quanta (fixed_point.hpp).
#pragma once

#include <cstdint>

namespace hg {

inline constexpr int kChunkCells = 8;

// Where the chunks of a neighbouring row lie, as seen from a chunk at X: of X - 1, X and X + 1 there those that exist.
// All three have consecutive units, as if they existed; a unit is 8 cells in cell_begin.
struct ChunkWord {
  static constexpr int32_t kFlags = 16;             // word = unit of X there * kFlags + 4 * last + first
  static constexpr int32_t kFirst = 3;              // mask: the first cell that exists, in chunks from X - 1 on
  static constexpr int32_t kLast = 12;              // mask: 4 times the chunk that ends with the last one
  static constexpr int32_t kNone = kFlags + 4 + 1;  // an empty range of cells
};

// In quanta: longer lengths are as good as this one, which floats hold.
inline constexpr double kBeyondAnyExtent = 0x1p60;

// What a search from elsewhere must allow for beyond the slack of a level.
inline constexpr double kFarSlack = 512;

// The forward half of the stencil: own row, next in y, and three in the next layer in z.
inline constexpr int kStencilRows = 5;

// Of one level, for the kernels. Cell c of unit u begins at cell_begin[8 u + c] in the sorted particles.
struct ChunkTable {
  float row_width;
  float inverse_cell;
  float largest_radius;               // folded, of the particles on the level
  float slack;                        // what a search must allow for: docs/theory/exactness.md, section 12
  const uint32_t *chunk_of;           // of each particle
  const int32_t *origin[3];           // of each chunk: its lower corner, modulo 2^32
  const int32_t *word[kStencilRows];  // of each chunk; none in a row: the flags say so
  const uint32_t *cell_begin;
};

// Chunks that points may meet, wherever they lie in their row; lower corners are relative to a place near the points.
struct NearChunks {
  static constexpr uint32_t kMost = 512;
  static constexpr uint32_t kPadded = kMost + 16;
  uint32_t count;
  float x[kPadded], y[kPadded], z[kPadded];
  int32_t cell[kPadded];  // the first, in cell_begin
};

}  // namespace hg
