// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// PairOrder against std::sort.
#include "src/pairs/pair_order.hpp"
#include "tests/unit/pairs/any_pairs.hpp"
#include "tests/unit/same_pairs.hpp"

namespace {

using namespace hgtest;

void check_any(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  hg::PairOrder order(memory);
  for (int pass = 0; pass < 3; pass++) {
    const int slots = rng.integer(0, 300);
    const int32_t base = rng.integer(0, 1);
    Pairs pairs = any_pairs(rng, slots, base);
    const Pairs expected = sorted(pairs.data(), pairs.size());
    order.ascend(pairs.data(), pairs.size(), static_cast<size_t>(slots), base);
    require_pairs("in order", pairs, expected);
  }
}

void any_pairs_in_order(void **) { assert_true(sweep(200, check_any)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_pairs_in_order)};
  return cmocka_run_group_tests_name("pair_order", tests, nullptr, nullptr);
}
