// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// PairOrder against std::sort.
#include "src/pairs/pair_order.hpp"
#include "tests/unit/any_pairs.hpp"

#include <algorithm>
#include <vector>

namespace {

using namespace hgtest;

void check_any(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  hg::PairOrder order(memory);
  for (int pass = 0; pass < 3; pass++) {
    const int slots = rng.integer(0, 300);
    const int32_t base = rng.integer(0, 1);
    std::vector<hg_pair> pairs = any_pairs(rng, slots, base), expected = pairs;
    std::sort(expected.begin(), expected.end(),
              [](const hg_pair &p, const hg_pair &q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
    order.ascend(pairs.data(), pairs.size(), static_cast<size_t>(slots), base);
    for (size_t k = 0; k < pairs.size(); k++) {
      require(pairs[k].a == expected[k].a && pairs[k].b == expected[k].b, "pair %zu is (%d, %d)", k, pairs[k].a,
              pairs[k].b);
    }
  }
}

void any_pairs_in_order(void **) { assert_true(sweep(200, check_any)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_pairs_in_order)};
  return cmocka_run_group_tests_name("pair_order", tests, nullptr, nullptr);
}
