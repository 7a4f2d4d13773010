// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The hierarchical grid exactly as Ogarko & Luding 2012 (section 2) write it: a plain second opinion for the library.
#pragma once

#include "programs/bench/cell_array.hpp"

#include <hgrid/types.h>

#include <vector>

namespace bench {

// All overlapping pairs (ids from 0, a < b, in no order) of an open system. `cell_sizes` are the s_h of the levels,
// ascending, the last at least the largest diameter. `tested` counts the candidates unless null.
// Throws std::invalid_argument if a particle fits into no level.
std::vector<hg_pair> hierarchical_grid_pairs(int dimension, const Particles &particles,
                                             const std::vector<double> &cell_sizes, int64_t *tested);

}  // namespace bench
