// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The other programs as contestants.
#pragma once

#include "programs/bench/search.hpp"

#include <vector>

namespace bench {

// All that this build has, in three dimensions; none in two.
std::vector<Contestant> peer_searches(int dimension);

}  // namespace bench
