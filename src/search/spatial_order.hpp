// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hg_query_order: an order of all particles in which near ones stand together.
#pragma once

#include "src/search/built_grid.hpp"

namespace hg {

// Writes the ids of all particles of the store, which has no gaps. Along a Morton curve, whatever the extents.
void order_along_space(const BuiltGrid &grid, Buffer<int32_t> &ids);

}  // namespace hg
