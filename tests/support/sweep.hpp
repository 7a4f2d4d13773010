// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// All pairs of a large open system, where a look at every pair takes too long: candidates are those whose extents
// along x overlap, the verdict is the oracle's.
#pragma once

#include "tests/support/oracle.hpp"

namespace hgtest {

// As all_pairs. No axis may be periodic. O(N log N + candidates).
Pairs swept_pairs(const hg_grid_def &def, const Particles &particles, Interact *interact);

}  // namespace hgtest
