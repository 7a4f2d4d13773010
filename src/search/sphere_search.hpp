// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hg_query_sphere: the particles that one sphere, not necessarily a particle, interacts with.
#pragma once

#include "src/search/built_grid.hpp"

namespace hg {

// Writes the ids of the particles met, ascending, into `ids` and returns their number. Throws an Error that names what
// is wrong with the sphere.
size_t query_sphere(const BuiltGrid &grid, const Ball &sphere, Buffer<int32_t> &ids);

// Whether two spheres interact that need not be particles, through any image. Throws an Error that names what is wrong
// with one of them.
bool overlaps(const Domain &domain, const Overlap &overlap, const Ball &a, const Ball &b);

}  // namespace hg
