// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How the cells of a level are laid over space: rows along x, wide in y and z, finely divided in x.
#pragma once

#include "src/space/cell_table.hpp"
#include "src/space/fixed_point.hpp"

#include <cstddef>

namespace hg {

// Row width and cell length in units of s_h. Wide rows make few ranges of candidates; short cells cut each range to the
// chord of the search sphere. Measured best for AVX2 and AVX-512: docs/evidence/performance.md.
inline constexpr double kRowWidth = 2;
inline constexpr double kCellLength = 0.5;

// Cells are first made longer, up to so many times, then wider as well: longer ones only add candidates at the ends of
// ranges, wider ones on all sides.
inline constexpr double kMostStretch = 8;

// A table of cells takes at most this many per particle of its level.
inline constexpr double kCellsPerParticle = 4;
inline constexpr double kFewCells = 64;

struct LevelCells {
  CellTable table{};
  size_t rows = 1;
  size_t cells = 1;
  bool widened = false;  // wider than s_h asks for, to bound memory: good only if space is filled evenly
};

// `cell_size`: s_h in quanta; `particles`: N_h > 0.
LevelCells lay_cells(const FixedPoint &map, int dimension, double cell_size, size_t particles);

}  // namespace hg
