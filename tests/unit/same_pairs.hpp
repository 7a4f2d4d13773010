// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Lists of pairs against those of the oracle.
#pragma once

#include "tests/support/oracle.hpp"
#include "tests/unit/checks.hpp"

#include <algorithm>

namespace hgtest {

inline Pairs sorted(const hg_pair *pairs, size_t count) {
  Pairs sorted(pairs, pairs + count);
  std::sort(sorted.begin(), sorted.end(), pair_less);
  return sorted;
}

// The same pairs in the same order.
inline bool same_pairs(const Pairs &p, const Pairs &q) {
  return std::equal(p.begin(), p.end(), q.begin(), q.end(), pair_equal);
}

inline void require_pairs(const char *what, const Pairs &found, const Pairs &expected) {
  require(same_pairs(found, expected), "%s: %zu pairs instead of %zu, or others", what, found.size(), expected.size());
}

}  // namespace hgtest
