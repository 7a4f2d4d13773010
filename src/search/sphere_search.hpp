// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hg_query_sphere and hg_query_spheres: the particles that spheres, not necessarily particles, interact with.
#pragma once

#include "src/search/built_grid.hpp"
#include "src/search/query_rows.hpp"

namespace hg {

// Writes the ids of the particles met, ascending, into `ids` and returns their number. Throws an Error that names what
// is wrong with the sphere.
size_t query_sphere(const BuiltGrid &grid, const Ball &sphere, Buffer<int32_t> &ids);

// The same of many spheres. centers: [count][dimension]; radii: [count].
void query_spheres(const BuiltGrid &grid, size_t count, const double *centers, const double *radii, QueryRows &rows);

// Whether two spheres interact that need not be particles, through any image. Throws an Error that names what is wrong
// with one of them.
bool overlaps(const Domain &domain, const Overlap &overlap, const Ball &a, const Ball &b);

}  // namespace hg
