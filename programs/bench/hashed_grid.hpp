// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The hierarchical grid with the data structures that Ogarko & Luding 2012 name: cells in a hash table (section 2.3),
// each a linked list of particles, boxes tested before spheres. What their K = 0.3 belongs to.
#pragma once

#include "programs/bench/cell_array.hpp"

#include <hgrid/types.h>

#include <cstdint>
#include <vector>

namespace bench {

// All overlapping pairs (ids from 0, a < b, in no order) of an open system in three dimensions. `cell_sizes` are the
// s_h of the levels, ascending, the last at least the largest diameter. `tested` counts the candidates unless null.
// Throws std::invalid_argument if a particle fits into no level.
std::vector<hg_pair> hashed_grid_pairs(const Particles &particles, const std::vector<double> &cell_sizes,
                                       int64_t *tested);

}  // namespace bench
