// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hg_query_boxes: the particles that axis-aligned boxes meet.
#pragma once

#include "src/search/built_grid.hpp"
#include "src/search/query_rows.hpp"

namespace hg {

// low, high: [count][dimension]. Throws an Error that names what is wrong with a box, or that the cell is tilted.
void query_boxes(const BuiltGrid &grid, size_t count, const double *low, const double *high, QueryRows &rows);

}  // namespace hg
