// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hg_query_triangles: the particles that the triangles of a wall mesh meet.
#pragma once

#include "src/search/built_grid.hpp"
#include "src/search/query_rows.hpp"

namespace hg {

// corners: [count][3 corners][3]. Throws an Error that names what is wrong with a triangle, or that the grid has two
// dimensions or a tilted cell.
void query_triangles(const BuiltGrid &grid, size_t count, const double *corners, QueryRows &rows);

}  // namespace hg
