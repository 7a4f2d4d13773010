// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// ContactHistory against a std::map from pairs to places: gaps around the length of its look ahead, changed order,
// pairs that come twice, and refused memory. tests/property walks through long random histories.
#include "src/history/contact_history.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/refusing_memory.hpp"
#include "tests/unit/same_pairs.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace {

using namespace hgtest;
using hg::ContactHistory;

Pairs chain(int count) {
  Pairs pairs;
  for (int k = 0; k < count; k++) pairs.push_back({k, 3 * k + 1});
  return pairs;
}

// The history remembers `now`, matched to `former`.
void require_matched(const char *what, const ContactHistory &history, const Pairs &former, const Pairs &now) {
  std::map<std::pair<int32_t, int32_t>, int64_t> places;
  for (size_t k = 0; k < former.size(); k++) places[{former[k].a, former[k].b}] = static_cast<int64_t>(k);
  require(history.matched() && history.former_count() == former.size(), "%s: matched to %zu pairs instead of %zu", what,
          history.former_count(), former.size());
  require_pairs(what, Pairs(history.now().pairs.data(), history.now().pairs.data() + history.now().count), now);
  for (size_t k = 0; k < now.size(); k++) {
    const auto found = places.find({now[k].a, now[k].b});
    const int64_t place = found == places.end() ? -1 : found->second;
    require(history.previous()[k] == place, "%s: pair %zu was at %lld instead of %lld", what, k,
            static_cast<long long>(history.previous()[k]), static_cast<long long>(place));
  }
}

void update(ContactHistory &history, const Pairs &pairs) { history.update(pairs.size(), pairs.data()); }

void check_change(const char *what, const Pairs &former, const Pairs &now) {
  ContactHistory history(hg::system_allocator());
  update(history, former);
  require_matched(what, history, {}, former);
  update(history, now);
  require_matched(what, history, former, now);
  update(history, former);
  require_matched(what, history, now, former);
}

// Runs of pairs that go, and new ones that come, shorter and longer than the look ahead.
void check_gaps(uint64_t seed) {
  const int gap = static_cast<int>(seed), count = 100;
  const Pairs all = chain(count);
  for (const int at : {0, 1, 40, count - gap}) {
    Pairs without = all;
    without.erase(without.begin() + at, without.begin() + std::min(at + gap, count));
    check_change("a run is gone", all, without);
    Pairs other = all;
    for (int k = at; k < std::min(at + gap, count); k++) other[static_cast<size_t>(k)] = {-1, k};
    check_change("a run is new", all, other);
  }
}

void check_orders(uint64_t seed) {
  Rng rng(seed);
  const Pairs all = chain(rng.integer(1, 200));
  Pairs other = all;
  std::reverse(other.begin(), other.end());
  check_change("reversed", all, other);
  std::rotate(other.begin(), other.begin() + static_cast<ptrdiff_t>(rng.below(other.size())), other.end());
  check_change("rotated", all, other);
  for (size_t k = other.size(); k > 1; k--) std::swap(other[k - 1], other[rng.below(k)]);
  check_change("shuffled", all, other);
  for (hg_pair &pair : other) {
    if (rng.chance(0.3)) std::swap(pair.a, pair.b);  // which is another pair
  }
  check_change("turned round", all, other);
  check_change("nothing left", all, {});
}

// A pair stands in the list once more: both places are named, and nothing has changed.
void check_twice(uint64_t seed) {
  Rng rng(seed);
  const Pairs first = chain(rng.integer(1, 60));
  Pairs second = first;
  for (hg_pair &pair : second) {
    if (rng.chance(0.3)) pair.b = -pair.b;
  }
  if (rng.chance(0.5)) std::reverse(second.begin(), second.end());
  ContactHistory history(hg::system_allocator());
  update(history, first);
  update(history, second);
  Pairs twice = rng.chance(0.5) ? second : first;
  const size_t from = rng.below(twice.size()), to = rng.below(twice.size() + 1);
  twice.insert(twice.begin() + static_cast<ptrdiff_t>(to), hg_pair(twice[from]));
  const size_t one = std::min(from, to), other = from < to ? to : from + 1;
  char text[128];
  std::snprintf(text, sizeof text, "pairs[%zu] = (%d, %d) is already listed as pairs[%zu]", other, twice[to].a,
                twice[to].b, one);
  require_refused("update", HG_ERR_ARGUMENT, text, [&] { update(history, twice); });
  require_matched("after a refusal", history, first, second);
  require_refused("restore", HG_ERR_ARGUMENT, text, [&] { history.restore(twice.size(), twice.data()); });
  require_matched("after a refusal", history, first, second);
}

// A restored list is matched to nothing, and the next one to it. Lists may come from the history itself.
void check_restore(uint64_t) {
  const Pairs all = chain(30), few = chain(3);
  ContactHistory history(hg::system_allocator());
  require(history.now().count == 0 && !history.matched() && history.former_count() == 0, "a new history remembers");
  update(history, few);
  history.restore(all.size(), all.data());
  require(!history.matched() && history.former_count() == 0, "a restored list is matched");
  require_pairs("restored", Pairs(history.now().pairs.data(), history.now().pairs.data() + history.now().count), all);
  update(history, few);
  require_matched("after a restore", history, all, few);
  history.update(history.now().count, history.now().pairs.data());
  require_matched("its own list", history, few, few);
  history.restore(0, few.data());
  update(history, all);
  require_matched("after nothing", history, {}, all);
}

// Each of the requests that a longer list makes is refused once.
void check_refused_memory(uint64_t) {
  Pairs few = chain(5), many = chain(5000);
  std::reverse(many.begin(), many.end());
  int refused = 0;
  for (bool done = false; !done; refused++) {
    ContactHistory history(refusing_allocator());
    update(history, few);
    update(history, few);
    const RefuseMemory after(refused);
    try {
      update(history, many);
      done = true;
    } catch (const hg::Error &error) {
      require(error.status() == HG_ERR_MEMORY, "status %d", static_cast<int>(error.status()));
      require_matched("without memory", history, few, few);
    }
  }
  require(refused > 3, "only %d requests", refused - 1);
}

void gaps(void **) { assert_true(sweep(40, check_gaps)); }
void orders(void **) { assert_true(sweep(100, check_orders)); }
void pairs_twice(void **) { assert_true(sweep(500, check_twice)); }
void restored_lists(void **) { assert_true(holds(0, check_restore)); }
void refused_memory(void **) { assert_true(holds(0, check_refused_memory)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(gaps), cmocka_unit_test(orders), cmocka_unit_test(pairs_twice),
                              cmocka_unit_test(restored_lists), cmocka_unit_test(refused_memory)};
  return cmocka_run_group_tests_name("contact_history", tests, nullptr, nullptr);
}
