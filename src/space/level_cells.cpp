// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/space/level_cells.hpp"

#include <algorithm>
#include <cmath>

namespace hg {
namespace {

constexpr double kMaxCellsPerAxis = 262144;  // 2^18, so that a cell is never below 4096 quanta
constexpr double kLeastCell = 4096.0;        // quanta

// Rows must be as wide as a search on their own level reaches, so that only next neighbours are visited.
double least_row_width(double cell_size) { return (cell_size + 2.0 * kSearchSlack) * (1.0 + 0x1p-16); }

// Kernels number cells with 32 bits.
constexpr double kMaxCells = 2147483647.0;

double count_along(double extent, double width) {
  return std::clamp(std::floor(extent / width), 1.0, kMaxCellsPerAxis);
}

double total(const double *extent, const double *width, int dimension) {
  double cells = 1;
  for (int axis = 0; axis < dimension; axis++) cells *= count_along(extent[axis], width[axis]);
  return cells;
}

}  // namespace

LevelCells lay_cells(const FixedPoint &map, int dimension, double cell_size, size_t particles) {
  double width[3];
  width[0] = std::max(kCellLength * cell_size, kLeastCell);
  width[1] = width[2] = std::max(kRowWidth * cell_size, least_row_width(cell_size));

  LevelCells level;
  level.widened = kCellLength * cell_size < kLeastCell;
  const double most = std::min(kCellsPerParticle * static_cast<double>(particles) + kFewCells, kMaxCells);
  const double wanted = total(map.extent, width, dimension);
  level.widened = level.widened || wanted > most;
  if (wanted > most) width[0] *= std::min(wanted / most, kMostStretch);
  for (;;) {
    const double cells = total(map.extent, width, dimension);
    if (cells <= most) break;
    const double grow = std::max(std::pow(cells / most, 1.0 / dimension), 1.01);
    for (double &w : width) w *= grow;
  }
  for (int axis = 0; axis < 3; axis++) {
    const double extent = axis < dimension ? map.extent[axis] : 0;
    const double count = axis < dimension ? count_along(extent, width[axis]) : 1;
    level.table.count[axis] = static_cast<int32_t>(count);
    level.table.width[axis] = static_cast<float>(std::max(extent / count, width[axis]));
    level.table.inverse_width[axis] = 1.0f / level.table.width[axis];
    level.cells *= static_cast<size_t>(count);
    if (axis > 0) level.rows *= static_cast<size_t>(count);
  }
  return level;
}

}  // namespace hg
