// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// radix_sort against std::stable_sort: keys of 0 to 64 bits, few or many different ones, in either of its two arrays.
// radix_sort_from_top against std::sort.
#include "src/base/radix_sort.hpp"
#include "tests/unit/checks.hpp"

#include <algorithm>
#include <vector>

namespace {

using namespace hgtest;

struct Entry {
  uint64_t key;
  uint32_t number;  // in the order that they had at first
  bool operator==(const Entry &other) const { return key == other.key && number == other.number; }
};

constexpr Entry kGuard = {0x123456789, 77};

uint64_t any_key(Rng &rng, int bits, int kind) {
  const uint64_t mask = bits == 0 ? 0 : ~uint64_t{0} >> (64 - bits);
  switch (kind) {
    case 0:
      return mask;  // all the same
    case 1:
      return (rng.next() % 3) << rng.integer(0, 62) & mask;  // few, which differ in some digits only
    case 2:
      return mask - rng.below(100) % (mask | 1);  // near the end
    default:
      return rng.next() & mask;
  }
}

void check(uint64_t seed, int bits) {
  Rng rng(seed);
  const size_t count = rng.chance(0.2) ? rng.below(4) : rng.below(3000);
  const int kind = rng.integer(0, 4);
  std::vector<Entry> entries(count);
  for (size_t i = 0; i < count; i++) entries[i] = {any_key(rng, bits, kind), static_cast<uint32_t>(i)};
  std::vector<Entry> expected = entries, other(count);
  std::stable_sort(expected.begin(), expected.end(), [](const Entry &a, const Entry &b) { return a.key < b.key; });
  entries.push_back(kGuard);
  other.push_back(kGuard);

  const Entry *sorted =
      hg::radix_sort(entries.data(), other.data(), count, bits, [](const Entry &entry) { return entry.key; });
  require(sorted == entries.data() || sorted == other.data(), "%d bits: sorted into a third place", bits);
  for (size_t i = 0; i < count; i++) {
    require(sorted[i] == expected[i], "%d bits: entry %zu of %zu is number %u instead of %u", bits, i, count,
            sorted[i].number, expected[i].number);
  }
  require(entries.back() == kGuard && other.back() == kGuard, "%d bits: written beyond the end", bits);
}

void as_a_stable_sort(void **) {
  for (int bits = 0; bits <= 64; bits++) {
    assert_true(sweep(25, [=](uint64_t seed) { check(100 * static_cast<uint64_t>(bits) + seed, bits); }));
  }
}

// A key may be narrower than 64 bits, or a part of an entry.
void any_key_type(void **) {
  assert_true(sweep(20, [](uint64_t seed) {
    Rng rng(seed);
    std::vector<uint32_t> entries(rng.below(500)), other(entries.size());
    for (uint32_t &entry : entries) entry = static_cast<uint32_t>(rng.next());
    std::vector<uint32_t> expected = entries;
    const auto high = [](uint32_t entry) { return entry >> 12; };
    std::stable_sort(expected.begin(), expected.end(), [&](uint32_t a, uint32_t b) { return high(a) < high(b); });
    const uint32_t *sorted = hg::radix_sort(entries.data(), other.data(), entries.size(), 20, high);
    require(std::equal(expected.begin(), expected.end(), sorted), "%zu words are in another order", entries.size());
  }));
}

// So many numbers that digits are longer; each is also its place before.
void many_numbers(void **) {
  assert_true(sweep(10, [](uint64_t seed) {
    Rng rng(seed);
    const int bits = rng.integer(0, 47);
    std::vector<uint64_t> entries((size_t{1} << 15) + rng.below(3) - 1), other(entries.size());
    for (size_t i = 0; i < entries.size(); i++) entries[i] = any_key(rng, bits, rng.integer(2, 4)) << 17 | i;
    std::vector<uint64_t> expected = entries;
    std::sort(expected.begin(), expected.end());
    const uint64_t *sorted =
        hg::radix_sort(entries.data(), other.data(), entries.size(), bits, [](uint64_t entry) { return entry >> 17; });
    require(std::equal(expected.begin(), expected.end(), sorted), "%zu numbers of %d bits are in another order",
            entries.size(), bits);
  }));
}

// Numbers of which few or many share their upper bits, so few or so many that runs of all lengths are left to sort.
void from_the_top(void **) {
  assert_true(sweep(200, [](uint64_t seed) {
    Rng rng(seed);
    const int bits = rng.integer(0, 64), shared = rng.integer(0, std::min(bits, 63));
    const size_t different = 1 + rng.below(20);
    std::vector<uint64_t> keys(rng.below(8000)), other(keys.size());
    for (uint64_t &key : keys) {
      key = any_key(rng, bits, 4);
      if (shared > 0 && !rng.chance(0.1))
        key = (key & ~uint64_t{0} >> shared) | rng.below(different) << (bits - shared);
      if (bits < 64) key &= (uint64_t{1} << bits) - 1;
    }
    std::vector<uint64_t> expected = keys;
    std::sort(expected.begin(), expected.end());
    const uint64_t *sorted = hg::radix_sort_from_top(keys.data(), other.data(), keys.size(), bits);
    require(std::equal(expected.begin(), expected.end(), sorted), "%zu numbers of %d bits, %d of them shared",
            keys.size(), bits, shared);
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(as_a_stable_sort), cmocka_unit_test(any_key_type),
                              cmocka_unit_test(many_numbers), cmocka_unit_test(from_the_top)};
  return cmocka_run_group_tests_name("radix_sort", tests, nullptr, nullptr);
}
