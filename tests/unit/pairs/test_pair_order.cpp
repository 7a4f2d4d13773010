// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// PairOrder against std::sort: few and many particles, ids that follow the list and ids that do not, one with all
// pairs, more pairs than are counted together.
#include "src/kernels/points.hpp"
#include "src/pairs/pair_order.hpp"
#include "tests/unit/pairs/any_pairs.hpp"
#include "tests/unit/same_pairs.hpp"

#include <limits>

namespace {

using namespace hgtest;

constexpr int32_t kLeastId = std::numeric_limits<int32_t>::min();

void check_order(hg::PairOrder &order, Pairs pairs, size_t slots, int32_t base) {
  const size_t count = pairs.size();
  const Pairs expected = sorted(pairs.data(), count);
  pairs.resize(count + hg::kPadding);
  order.ascend(pairs.data(), count, slots, base);
  pairs.resize(count);
  require_pairs("in order", pairs, expected);
}

// The same scratch serves lists of any size.
void check_any(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  hg::PairOrder order(memory, rng.chance(0.5) ? UINT32_MAX : rng.below(500));
  for (int pass = 0; pass < 3; pass++) {
    const int slots = rng.integer(0, 300);
    const int32_t base = rng.chance(0.2) ? kLeastId : rng.integer(0, 1);
    check_order(order, any_pairs(rng, slots, base), static_cast<size_t>(slots), base);
  }
}

// Particles beyond the caches; each with `partners` among those up to `near` ids away.
Pairs near_pairs(Rng &rng, int slots, int partners, int near, int32_t base) {
  Pairs pairs;
  for (int a = 0; a + 1 < slots; a++) {
    for (int n = rng.integer(0, 2 * partners); n > 0; n--) {
      const int b = static_cast<int>(std::min<int64_t>(slots - 1, int64_t{a} + rng.integer(1, near)));
      pairs.push_back({base + a, base + b});
    }
  }
  return pairs;
}

void shuffle(Rng &rng, Pairs &pairs) {
  for (size_t k = pairs.size(); k > 1; k--) std::swap(pairs[k - 1], pairs[rng.below(k)]);
}

void check_large(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  const bool few_counted = rng.chance(0.3);
  hg::PairOrder order(memory, few_counted ? 6000 : UINT32_MAX);
  const int slots = rng.integer(262144, 300000);
  const int32_t base = rng.chance(0.2) ? kLeastId : rng.integer(0, 1);
  Pairs pairs = near_pairs(rng, slots, rng.integer(1, 3), 1 << rng.integer(1, 18), base);
  const auto check = [&] { check_order(order, pairs, static_cast<size_t>(slots), base); };
  check();
  std::reverse(pairs.begin(), pairs.end());
  check();
  shuffle(rng, pairs);
  check();
  const int hub = rng.integer(0, slots - 40000);
  for (int k = 1; k < 40000; k++) pairs.push_back({base + hub, base + hub + k});
  shuffle(rng, pairs);
  check();
}

// A particle with all pairs, and nothing else.
void check_star(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  hg::PairOrder order(memory);
  Pairs pairs;
  for (int32_t k = 1; k <= static_cast<int32_t>(seed); k++) pairs.push_back({0, k});
  check_order(order, pairs, seed + 1, 0);
  std::reverse(pairs.begin(), pairs.end());
  check_order(order, pairs, seed + 1, 0);
  shuffle(rng, pairs);
  check_order(order, pairs, seed + 1, 0);
}

void any_pairs_in_order(void **) { assert_true(sweep(200, check_any)); }
void large_lists(void **) { assert_true(sweep(12, check_large)); }
void one_has_all(void **) { assert_true(sweep(101, check_star)); }

// Ids in any order, of more particles than caches hold.
void scattered(void **) {
  assert_true(holds(0, [](uint64_t) {
    Rng rng(1);
    for (const int slots : {0, 1, 100000, 262144, 262145, 400000}) {
      Pairs pairs = near_pairs(rng, slots, 2, 100, 0);
      const auto ask = [&] {
        return hg::is_scattered(pairs.size(), static_cast<size_t>(slots), [&](size_t k) { return pairs[k].a; });
      };
      require(!ask(), "%d slots in order", slots);
      std::reverse(pairs.begin(), pairs.end());
      require(!ask(), "%d slots in order from the end", slots);
      for (size_t k = 1; k + 30000 < pairs.size(); k += 2) std::swap(pairs[k], pairs[k + 30000]);
      require(!ask(), "%d slots, layer by layer", slots);
      shuffle(rng, pairs);
      require(ask() == (slots > 262144), "%d slots in any order", slots);
    }
  }));
}

// 12 bytes a pair at most, and what counters take.
void bounded_memory(void **) {
  assert_true(holds(0, [](uint64_t) {
    Rng rng(1);
    hg::Memory memory(hg::system_allocator());
    constexpr int kSlots = 400000;
    for (const bool shuffled : {false, true}) {
      Pairs pairs = near_pairs(rng, kSlots, 2, 100, 0);
      if (shuffled) shuffle(rng, pairs);
      hg::PairOrder order(memory);
      const size_t count = pairs.size();
      check_order(order, std::move(pairs), kSlots, 0);
      const auto most = static_cast<int64_t>((shuffled ? 9 : 4) * (count + count / 8) + (shuffled ? 0 : 4 * kSlots));
      require(memory.bytes() < most + 100000, "%lld bytes for %zu pairs", static_cast<long long>(memory.bytes()),
              count);
    }
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_pairs_in_order), cmocka_unit_test(large_lists),
                              cmocka_unit_test(one_has_all), cmocka_unit_test(scattered),
                              cmocka_unit_test(bounded_memory)};
  return cmocka_run_group_tests_name("pair_order", tests, nullptr, nullptr);
}
