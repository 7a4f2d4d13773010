// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The classical linked-cell search, the yardstick of the paper: one grid of cells as wide as the largest particle.
#pragma once

#include "programs/bench/cell_array.hpp"

#include <hgrid/types.h>

#include <vector>

namespace bench {

// All overlapping pairs (ids from 0, a < b, in no order) of an open system. `tested` counts the candidates unless null.
std::vector<hg_pair> linked_cell_pairs(int dimension, const Particles &particles, int64_t *tested);

}  // namespace bench
