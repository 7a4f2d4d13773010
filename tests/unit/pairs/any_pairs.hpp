// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Random lists of pairs, each once and in any order.
#pragma once

#include "tests/unit/checks.hpp"

#include <hgrid/types.h>

#include <set>
#include <utility>
#include <vector>

namespace hgtest {

inline std::vector<hg_pair> any_pairs(Rng &rng, int rows, int32_t base) {
  std::set<std::pair<int32_t, int32_t>> chosen;
  const uint64_t wanted = rows < 2 ? 0 : rng.below(3 * static_cast<uint64_t>(rows));
  for (uint64_t k = 0; k < wanted; k++) {
    // One row of many neighbours now and then: long rows are sorted in another way.
    const int a = rng.chance(0.3) ? 0 : rng.integer(0, rows - 2), b = rng.integer(a + 1, rows - 1);
    chosen.insert({a + base, b + base});
  }
  std::vector<hg_pair> pairs;
  pairs.reserve(chosen.size());
  for (const auto &p : chosen) pairs.push_back({p.first, p.second});
  for (size_t k = pairs.size(); k > 1; k--) std::swap(pairs[k - 1], pairs[rng.below(k)]);
  return pairs;
}

}  // namespace hgtest
