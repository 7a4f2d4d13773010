// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid::History: each member, and its failures.
#include "tests/cpp/chain.hpp"

#include <vector>

namespace {

using namespace hgtest;

constexpr hg_pair kFirst[] = {{0, 1}, {1, 2}};
constexpr hg_pair kSecond[] = {{1, 2}, {2, 3}, {0, 1}};

void data_follow_their_contacts() {
  hgrid::History history;
  require(history.update(2, kFirst)[0] == -1, "a pair that was never there");
  const hgrid::View<int64_t> previous = history.update(3, kSecond);
  require(std::vector<int64_t>(previous.begin(), previous.end()) == std::vector<int64_t>{1, -1, 0}, "places");
  const double before[] = {10, 20};
  double now[3] = {7, 7, 7};
  history.carry(sizeof(double), before, now);
  require(now[0] == 20 && now[1] == 0 && now[2] == 10, "items");
  require(history.update(0, nullptr).empty(), "a list of nothing");
}

void lists_are_remembered() {
  hgrid::History history, restored;
  history.update(3, kSecond);
  const hgrid::View<hg_pair> pairs = history.pairs();
  require_same("remembered", Pairs(pairs.begin(), pairs.end()), Pairs(kSecond, kSecond + 3));
  restored.restore(pairs.size(), pairs.data());
  require(restored.update(2, kFirst)[1] == 0, "a restored list is not matched");
  restored.clear();
  require(restored.pairs().empty(), "a cleared history remembers");
  const hg_pair *list = nullptr;
  size_t count = 0;
  hgrid::check(hg_history_pairs(history.get(), &list, &count));
  require(list == history.pairs().data() && count == 3, "the view is not the list of C");
}

void keys_and_what_ended() {
  const hg_contact_key first[] = {{0, 1, 0}, {0, 1, 1}, {5, 6, -1}}, second[] = {{5, 6, -1}, {0, 1, 2}};
  hgrid::History history, restored;
  history.update_keys(3, first);
  const hgrid::View<int64_t> previous = history.update_keys(2, second);
  require(previous.size() == 2 && previous[0] == 2 && previous[1] == -1, "places of keys");
  require(history.keys().size() == 2 && history.keys()[1].sub == 2, "the remembered keys");
  const hgrid::EndedKeys ended = history.ended_keys();
  require(ended.keys.size() == 2 && ended.keys[1].sub == 1 && ended.places.size() == 2 && ended.places[1] == 1,
          "keys that ended");
  restored.restore_keys(2, second);
  restored.update(2, kFirst);
  require(restored.ended_keys().places.size() == 2, "keys before pairs");
  restored.update(0, nullptr);
  const hgrid::EndedPairs pairs = restored.ended();
  require(pairs.pairs.size() == 2 && pairs.pairs[1].a == 1 && pairs.places[1] == 1, "pairs that ended");
}

void failures_tell_status_and_text() {
  hgrid::History history;
  const hg_pair twice[] = {{4, 5}, {4, 5}};
  require_error(HG_ERR_ARGUMENT, "pairs[1] = (4, 5)", [&] { history.update(2, twice); });
  require_error(HG_ERR_ARGUMENT, "pairs[1] = (4, 5)", [&] { history.restore(2, twice); });
  require_error(HG_ERR_NULL, "pairs", [&] { history.update(1, nullptr); });
  require_error(HG_ERR_STATE, "no list", [&] { history.ended(); });
  require_error(HG_ERR_STATE, "no list", [&] { history.ended_keys(); });
  const hg_contact_key keys_twice[] = {{4, 5, 6}, {4, 5, 6}};
  require_error(HG_ERR_ARGUMENT, "keys[1] = (4, 5, 6)", [&] { history.update_keys(2, keys_twice); });
  require_error(HG_ERR_ARGUMENT, "keys[1] = (4, 5, 6)", [&] { history.restore_keys(2, keys_twice); });
  require_error(HG_ERR_STATE, "no list", [&] { history.carry(8, nullptr, nullptr); });
  history.update(0, nullptr);
  require_error(HG_ERR_ARGUMENT, "item_size = 0", [&] { history.carry(0, nullptr, nullptr); });
  require(history.pairs().empty(), "a failure has changed the list");
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(run<data_follow_their_contacts>),
                              cmocka_unit_test(run<lists_are_remembered>), cmocka_unit_test(run<keys_and_what_ended>),
                              cmocka_unit_test(run<failures_tell_status_and_text>)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
