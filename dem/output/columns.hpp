// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Vectors of either dimension as the three columns that pictures have.
#pragma once

#include "dem/engine/engine.hpp"

#include <cstddef>
#include <vector>

namespace output {

// [count][dimension] to [count][3], the third 0 in two dimensions.
inline std::vector<double> three_columns(const std::vector<double> &rows, int dimension) {
  if (dimension == 3) return rows;
  std::vector<double> result;
  result.reserve(rows.size() / 2 * 3);
  for (size_t k = 0; k + 1 < rows.size(); k += 2) result.insert(result.end(), {rows[k], rows[k + 1], 0.0});
  return result;
}

// Spins in three columns: in two dimensions they point along z.
inline std::vector<double> spin_columns(const dem::Snapshot &state) {
  if (state.dimension == 3) return state.spins;
  std::vector<double> result;
  for (const double spin : state.spins) result.insert(result.end(), {0.0, 0.0, spin});
  return result;
}

}  // namespace output
