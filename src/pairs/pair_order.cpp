// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/pairs/pair_order.hpp"

#include <algorithm>

namespace hg {
namespace {

constexpr uint64_t kShortRun = 32;  // insertion beats std::sort up to here

bool comes_first(const hg_pair &p, const hg_pair &q) { return p.a < q.a || (p.a == q.a && p.b < q.b); }

}  // namespace

void PairOrder::ascend(hg_pair *pairs, size_t count, size_t slots, int32_t base) {
  begin_.require(slots + 1);
  by_first_.require_room(count);
  uint64_t *begin = begin_.data();
  hg_pair *by_first = by_first_.data();
  std::fill(begin, begin + slots + 1, uint64_t{0});
  for (size_t p = 0; p < count; p++) begin[pairs[p].a - base]++;
  uint64_t sum = 0, longest = 0;
  for (size_t slot = 0; slot <= slots; slot++) {
    const uint64_t here = begin[slot];
    longest = std::max(longest, here);
    begin[slot] = sum;
    sum += here;
  }
  for (size_t p = 0; p < count; p++) by_first[begin[pairs[p].a - base]++] = pairs[p];
  if (longest > kShortRun) {
    // Each begin has moved to the end of its run.
    for (size_t slot = 0; slot < slots; slot++) {
      hg_pair *const run = by_first + (slot > 0 ? begin[slot - 1] : 0), *const end = by_first + begin[slot];
      if (end - run > static_cast<ptrdiff_t>(kShortRun)) std::sort(run, end, comes_first);
    }
  }
  // Runs are short and mostly in order: one insertion over all of them, without a branch for where a run ends.
  for (size_t p = 0; p < count; p++) {
    const hg_pair pair = by_first[p];
    size_t place = p;
    for (; place > 0 && comes_first(pair, pairs[place - 1]); place--) pairs[place] = pairs[place - 1];
    pairs[place] = pair;
  }
}

}  // namespace hg
