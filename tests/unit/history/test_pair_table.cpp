// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// PairTable against std::map, and with keys that were chosen against its hash.
#include "src/history/pair_table.hpp"
#include "tests/unit/checks.hpp"

#include <map>
#include <vector>

namespace {

using namespace hgtest;
using hg::PairFilter;
using hg::PairTable;

void require_holds(PairTable &table, const std::map<uint64_t, int64_t> &expected, uint64_t key) {
  const auto found = expected.find(key);
  const int64_t value = table.locate(key).value;
  require(value == (found == expected.end() ? PairTable::kEmpty : found->second), "key %llx has value %lld",
          static_cast<unsigned long long>(key), static_cast<long long>(value));
}

void check_any(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  PairTable table(memory);
  PairFilter filter(memory);
  for (int pass = 0; pass < 3; pass++) {
    const size_t count = rng.below(400);
    // Few bits make keys that come again and neighbours in number.
    const int bits = rng.integer(4, 64);
    table.reset(count);
    filter.reset(count);
    std::map<uint64_t, int64_t> expected;
    for (size_t k = 0; k < count; k++) {
      const uint64_t key = rng.next() >> (64 - bits);
      require_holds(table, expected, key);
      table.locate(key) = {key, static_cast<int64_t>(k)};
      filter.add(key);
      expected[key] = static_cast<int64_t>(k);
    }
    for (const auto &entry : expected) {
      require_holds(table, expected, entry.first);
      require(filter.may_hold(entry.first), "the filter lost a key");
    }
    for (int k = 0; k < 200; k++) require_holds(table, expected, rng.next() >> (64 - bits));
  }
}

void any_keys(void **) { assert_true(sweep(300, check_any)); }

// About one in 16 other keys passes a full filter.
void filter_stops_most(void **) {
  assert_true(holds(1, [](uint64_t seed) {
    Rng rng(seed);
    hg::Memory memory(hg::system_allocator());
    PairFilter filter(memory);
    filter.reset(1000);
    for (uint64_t key = 0; key < 1000; key++) filter.add(key << 32 | (key * 7));
    int passed = 0;
    for (int k = 0; k < 10000; k++) passed += filter.may_hold(rng.next()) ? 1 : 0;
    require(passed > 300 && passed < 1000, "%d of 10000 passed", passed);
  }));
}

// All keys begin in the first part in a thousand of the table: without another seed, `count` of them would take about
// count^2 / 2 steps.
void hostile_keys(void **) {
  assert_true(holds(2, [](uint64_t seed) {
    constexpr size_t kCount = 20000;
    Rng rng(seed);
    hg::Memory memory(hg::system_allocator());
    PairTable table(memory);
    std::vector<uint64_t> keys;
    while (keys.size() < kCount) {
      const uint64_t key = rng.next();
      if (PairTable::first_hash(key) < UINT64_MAX / 1000) keys.push_back(key);
    }
    table.reset(kCount);
    std::map<uint64_t, int64_t> expected;
    for (size_t k = 0; k < kCount; k++) {
      table.locate(keys[k]) = {keys[k], static_cast<int64_t>(k)};
      expected[keys[k]] = static_cast<int64_t>(k);
    }
    for (const uint64_t key : keys) require_holds(table, expected, key);
    require(table.steps() > kCount / 10 && table.steps() < 40 * kCount, "%llu steps",
            static_cast<unsigned long long>(table.steps()));
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_keys), cmocka_unit_test(filter_stops_most),
                              cmocka_unit_test(hostile_keys)};
  return cmocka_run_group_tests_name("pair_table", tests, nullptr, nullptr);
}
