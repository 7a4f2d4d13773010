// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The map from coordinates to cells, written down plainly: floats, clamped to the table.
#pragma once

#include "src/space/cell_table.hpp"

#include <algorithm>
#include <cstddef>

namespace hgtest {

inline size_t plain_cell(int32_t count, float inverse_width, int32_t x) {
  const float last = static_cast<float>(count) - 0.5f;
  return static_cast<size_t>(std::min(std::max(static_cast<float>(x) * inverse_width, 0.0f), last));
}

inline size_t plain_cell(const hg::CellTable &cells, int axis, int32_t x) {
  return plain_cell(cells.count[axis], cells.inverse_width[axis], x);
}

}  // namespace hgtest
