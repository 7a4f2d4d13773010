// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The generator against published output, and its mappings against what they must fulfil.
#include "packing/random.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <numeric>

namespace {

constexpr uint64_t kSeed = 7;

// The first outputs of xoshiro256++ 1.0 from the state 1, 2, 3, 4.
void generator_gives_the_published_numbers(void **) {
  packing::Random random(packing::Random::State{1, 2, 3, 4});
  for (const uint64_t expected : {41943041ull, 58720359ull, 3588806011781223ull, 3591011842654386ull,
                                  9228616714210784205ull, 9973669472204895162ull}) {
    assert_true(random.next() == expected);
  }
}

void seeds_differ_and_repeat(void **) {
  packing::Random one(kSeed), same(kSeed), other(kSeed + 1);
  const uint64_t number = one.next();
  assert_true(number == same.next());
  assert_true(number != other.next());
}

void uniform_numbers_fill_the_interval(void **) {
  packing::Random random(kSeed);
  constexpr int kCount = 100000;
  double sum = 0, lowest = 1, highest = 0;
  for (int k = 0; k < kCount; k++) {
    const double x = random.uniform();
    sum += x;
    lowest = std::min(lowest, x);
    highest = std::max(highest, x);
  }
  assert_true(lowest >= 0 && lowest < 1e-3);
  assert_true(highest < 1 && highest > 1 - 1e-3);
  // Five standard deviations of the mean, 1 / sqrt(12 N).
  assert_true(sum / kCount > 0.5 - 0.0046 && sum / kCount < 0.5 + 0.0046);
}

void small_bounds_are_even(void **) {
  packing::Random random(kSeed);
  int counts[3] = {0, 0, 0};
  for (int k = 0; k < 30000; k++) ++counts[random.below(3)];
  // Expected 10000 each, standard deviation 82.
  for (const int count : counts) assert_true(count > 9590 && count < 10410);
  assert_true(random.below(1) == 0);
}

bool shuffle_keeps_all_items() {
  packing::Random random(kSeed);
  std::vector<int> items(1000);
  std::iota(items.begin(), items.end(), 0);
  packing::shuffle(items, random);
  const bool moved = !std::is_sorted(items.begin(), items.end());
  std::sort(items.begin(), items.end());
  for (int k = 0; k < 1000; k++) {
    if (items[static_cast<size_t>(k)] != k) return false;
  }
  return moved;
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(generator_gives_the_published_numbers), cmocka_unit_test(seeds_differ_and_repeat),
      cmocka_unit_test(uniform_numbers_fill_the_interval),     cmocka_unit_test(small_bounds_are_even),
      cmocka_unit_test(passes<shuffle_keeps_all_items>),
  };
  return cmocka_run_group_tests_name("random", tests, nullptr, nullptr);
}
