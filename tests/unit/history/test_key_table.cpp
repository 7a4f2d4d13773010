// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// KeyTable against std::map, for both kinds of keys, and with keys that were chosen against its hash.
#include "src/history/key_table.hpp"
#include "tests/unit/checks.hpp"

#include <map>
#include <tuple>
#include <vector>

namespace {

using namespace hgtest;
using hg::KeyFilter;

// Few bits make keys that come again and neighbours in number.
void make_key(Rng &rng, int bits, uint64_t &key) { key = rng.next() >> (64 - bits); }
void make_key(Rng &rng, int bits, hg_contact_key &key) {
  for (int64_t *const number : {&key.a, &key.b, &key.sub}) {
    *number = rng.chance(0.5) ? 0 : static_cast<int64_t>(rng.next() >> (64 - bits));
  }
}

// What std::map goes by.
uint64_t order_of(uint64_t key) { return key; }
std::tuple<int64_t, int64_t, int64_t> order_of(const hg_contact_key &key) { return {key.a, key.b, key.sub}; }

template <class Key>
void check_any(uint64_t seed) {
  using Table = hg::KeyTable<Key>;
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  Table table(memory);
  KeyFilter filter(memory);
  for (int pass = 0; pass < 3; pass++) {
    const size_t count = rng.below(400);
    const int bits = rng.integer(4, 64);
    table.reset(count);
    filter.reset(count);
    std::map<decltype(order_of(Key{})), int64_t> expected;
    Key key{};
    const auto require_holds = [&] {
      const auto found = expected.find(order_of(key));
      const int64_t value = table.locate(key).value;
      require(value == (found == expected.end() ? Table::kEmpty : found->second), "a key has value %lld",
              static_cast<long long>(value));
      require(found == expected.end() || filter.may_hold(key), "the filter lost a key");
    };
    for (size_t k = 0; k < count; k++) {
      make_key(rng, bits, key);
      require_holds();
      table.locate(key) = {key, static_cast<int64_t>(k)};
      filter.add(key);
      expected[order_of(key)] = static_cast<int64_t>(k);
      require_holds();
    }
    for (int k = 0; k < 200; k++) {
      make_key(rng, bits, key);
      require_holds();
    }
  }
}

void any_keys(void **) { assert_true(sweep(300, check_any<uint64_t>) && sweep(300, check_any<hg_contact_key>)); }

// About one in 16 other keys passes a full filter.
void filter_stops_most(void **) {
  assert_true(holds(1, [](uint64_t seed) {
    Rng rng(seed);
    hg::Memory memory(hg::system_allocator());
    KeyFilter filter(memory);
    filter.reset(1000);
    for (uint64_t key = 0; key < 1000; key++) filter.add(key << 32 | (key * 7));
    int passed = 0;
    for (int k = 0; k < 10000; k++) passed += filter.may_hold(rng.next()) ? 1 : 0;
    require(passed > 300 && passed < 1000, "%d of 10000 passed", passed);
  }));
}

void fill(Rng &rng, uint64_t &key) { key = rng.next(); }
void fill(Rng &rng, hg_contact_key &key) { key = {7, static_cast<int64_t>(rng.next()), rng.integer(0, 3)}; }

// All keys begin in the first part in a thousand of the table: without another seed, `count` of them would take about
// count^2 / 2 steps.
template <class Key>
void check_hostile(uint64_t seed) {
  using Table = hg::KeyTable<Key>;
  constexpr size_t kCount = 20000;
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  Table table(memory);
  std::vector<Key> keys;
  while (keys.size() < kCount) {
    Key key{};
    fill(rng, key);
    if (Table::first_hash(key) < UINT64_MAX / 1000) keys.push_back(key);
  }
  table.reset(kCount);
  for (size_t k = 0; k < kCount; k++) table.locate(keys[k]) = {keys[k], static_cast<int64_t>(k)};
  for (size_t k = 0; k < kCount; k++) {
    require(table.locate(keys[k]).value == static_cast<int64_t>(k), "key %zu has another place", k);
  }
  require(table.steps() > kCount / 10 && table.steps() < 40 * kCount, "%llu steps",
          static_cast<unsigned long long>(table.steps()));
}

void hostile_keys(void **) {
  assert_true(holds(2, check_hostile<uint64_t>) && holds(2, check_hostile<hg_contact_key>));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_keys), cmocka_unit_test(filter_stops_most),
                              cmocka_unit_test(hostile_keys)};
  return cmocka_run_group_tests_name("key_table", tests, nullptr, nullptr);
}
