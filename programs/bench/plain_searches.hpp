// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The plain searches of this folder as contestants.
#pragma once

#include "programs/bench/search.hpp"

namespace bench {

inline constexpr const char *kClassical = "classical";
inline constexpr const char *kPlain = "plain";
inline constexpr const char *kHashed = "hashed";

Contestant linked_cell_search();

// With the levels of the paper's rule, at most `level_count` of them (0: as the rule chooses). Choosing them is not
// part of the time.
Contestant hierarchical_grid_search(int level_count);
// The same on linked lists in a hash table; three dimensions only.
Contestant hashed_grid_search(int level_count);

}  // namespace bench
