// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How the cells of a level are laid over space: rows along x, wide in y and z, finely divided in x.
#pragma once

#include "src/kernels/kernel.hpp"
#include "src/space/frame.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace hg {

// Row width and cell length in units of s_h. Wide rows make few ranges of candidates; short cells cut each range to the
// chord of the search sphere. Measured best for the scalar kernel, see docs/decisions/0004-rows-and-cells.md.
inline constexpr double kRowWidth = 2;
inline constexpr double kCellLength = 0.5;

// Cells are first made longer, up to so many times, then wider as well: longer ones only add candidates at the ends of
// ranges, wider ones on all sides.
inline constexpr double kMostStretch = 8;

// A table of cells takes at most this many per particle of its level.
inline constexpr double kCellsPerParticle = 4;
inline constexpr double kFewCells = 64;

// Others in a particle's own cell beyond which a widened table does not pay, and the level keeps sparse rows instead.
inline constexpr double kMaxCrowding = 40;

// The map from coordinates to cells, as in the kernels, which have copies of their own (kernels/search.hpp, keys.hpp).
inline int32_t cell_of(const CellTable &cells, int axis, float x) {
  const float last = static_cast<float>(cells.count[axis]) - 0.5f;
  return static_cast<int32_t>(std::min(std::max(x * cells.inverse_width[axis], 0.0f), last));
}

struct LevelCells {
  CellTable table{};
  size_t rows = 1;
  size_t cells = 1;
  bool widened = false;  // wider than s_h asks for, to bound memory: good only if space is filled evenly
};

// `cell_size`: s_h in quanta; `particles`: N_h > 0.
LevelCells lay_cells(const Frame &frame, int dimension, double cell_size, size_t particles);

}  // namespace hg
