// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Contact histories against a std::map from keys to places, through lists of pairs and of keys that grow, shrink,
// change their order, take ids from anywhere, and sometimes hold a contact twice.
#include "tests/support/compare.hpp"
#include "tests/support/rng.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace {

using namespace hgtest;

using List = std::vector<hg_contact_key>;
using Key = std::tuple<int64_t, int64_t, int64_t>;
using Places = std::map<Key, int64_t>;

Key key_of(const hg_contact_key &contact) { return {contact.a, contact.b, contact.sub}; }

Places places_of(const List &contacts) {
  Places places;
  for (size_t k = 0; k < contacts.size(); k++) places.insert({key_of(contacts[k]), static_cast<int64_t>(k)});
  return places;
}

bool equal(const List &one, const List &other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const hg_contact_key &x, const hg_contact_key &y) { return key_of(x) == key_of(y); });
}

List widened(const hgrid::View<hg_pair> &pairs) {
  List keys;
  for (const hg_pair &pair : pairs) keys.push_back({pair.a, pair.b, 0});
  return keys;
}

List list_of(const hgrid::View<hg_contact_key> &keys) { return {keys.begin(), keys.end()}; }

class Walk {
 public:
  explicit Walk(uint64_t seed)
      : rng_(seed),
        id_bits_(rng_.integer(4, 32)),
        hub_(rng_.chance(0.2)),
        keyed_share_(rng_.chance(0.3)   ? 0
                     : rng_.chance(0.3) ? 1
                                        : rng_.uniform()),
        far_(rng_.chance(0.3)) {}

  void run(int steps) {
    for (int step = 0; step < steps; step++) {
      change();
      const int action = rng_.integer(0, 19);
      if (action == 0) {
        restore();
      } else if (action == 1) {
        clear();
      } else if (action < 5 && !next_.empty()) {
        refuse();
      } else {
        update();
      }
    }
  }

 private:
  int32_t any_id() { return static_cast<int32_t>(rng_.next() >> (64 - id_bits_)); }

  // A pair, or where the next list is one of keys, one that may have a sub-key or large ids.
  hg_contact_key any_contact() {
    hg_contact_key contact = {hub_ && rng_.chance(0.7) ? 7 : any_id(), any_id(), 0};
    if (!keyed_ || rng_.chance(0.3)) return contact;
    contact.sub = rng_.integer(-2, 2);
    if (far_) (rng_.chance(0.5) ? contact.a : contact.sub) += rng_.integer(-2, 2) * (int64_t{1} << 40);
    return contact;
  }

  // The next list: that of the last step with some contacts gone, some new, parts of it moved, or all mixed up. One of
  // pairs after one of keys takes those that are pairs.
  void change() {
    keyed_ = rng_.chance(keyed_share_);
    next_.clear();
    Places seen;
    const double gone = rng_.chance(0.3) ? rng_.uniform() : 0.02, fresh = rng_.chance(0.3) ? rng_.uniform() : 0.02;
    const auto append = [&](const hg_contact_key &contact) {
      const bool is_pair = contact.sub == 0 && contact.a == static_cast<int32_t>(contact.a);
      if ((keyed_ || is_pair) && seen.insert({key_of(contact), 0}).second) next_.push_back(contact);
    };
    for (const hg_contact_key &contact : last_) {
      if (!rng_.chance(gone)) append(contact);
      if (rng_.chance(fresh)) append(any_contact());
    }
    for (int k = rng_.integer(0, last_.size() < 100 ? 200 : 5); k > 0; k--) append(any_contact());
    if (rng_.chance(0.3)) {
      const auto middle = next_.begin() + static_cast<ptrdiff_t>(rng_.below(next_.size() + 1));
      std::rotate(next_.begin(), middle, next_.end());
    }
    if (rng_.chance(0.3)) {
      for (size_t k = next_.size(); k > 1; k--) std::swap(next_[k - 1], next_[rng_.below(k)]);
    }
  }

  std::vector<hg_pair> next_pairs() const {
    std::vector<hg_pair> pairs;
    for (const hg_contact_key &contact : next_) {
      pairs.push_back({static_cast<int32_t>(contact.a), static_cast<int32_t>(contact.b)});
    }
    return pairs;
  }

  hgrid::View<int64_t> give() {
    return keyed_ ? history_.update_keys(next_.size(), next_.data())
                  : history_.update(next_.size(), next_pairs().data());
  }
  void give_restored() {
    keyed_ ? history_.restore_keys(next_.size(), next_.data()) : history_.restore(next_.size(), next_pairs().data());
  }

  void update() {
    const Places places = places_of(last_);
    const hgrid::View<int64_t> previous = give();
    std::vector<int64_t> old_items(last_.size()), items(next_.size(), -1);
    for (size_t k = 0; k < last_.size(); k++) old_items[k] = static_cast<int64_t>(k) + 1;
    history_.carry(sizeof items[0], old_items.data(), items.data());
    for (size_t k = 0; k < next_.size(); k++) {
      const auto found = places.find(key_of(next_[k]));
      const int64_t expected = found == places.end() ? -1 : found->second;
      require(previous[k] == expected, "contact " + std::to_string(k) + " was at " + std::to_string(previous[k]) +
                                           " instead of " + std::to_string(expected));
      require(items[k] == expected + 1, "item " + std::to_string(k) + " is " + std::to_string(items[k]));
    }
    former_ = last_;
    former_keyed_ = last_keyed_;
    matched_ = true;
    remember();
  }

  void restore() {
    give_restored();
    matched_ = false;
    remember();
  }

  void clear() {
    history_.clear();
    next_.clear();
    matched_ = false;
    remember();
  }

  void remember() {
    last_ = next_;
    last_keyed_ = keyed_;
    require_remembered();
    if (rng_.chance(0.5)) require_ended();
  }

  void require_remembered() {
    require(equal(last_keyed_ ? list_of(history_.keys()) : widened(history_.pairs()), last_), "another list");
  }

  // Contacts of the list before that are not in the last one.
  void require_ended() {
    if (!matched_) {
      require(status_of([&] { history_.ended(); }) == HG_ERR_STATE, "ended contacts of a list that was not matched");
      return;
    }
    List ended;
    std::vector<int64_t> places;
    const Places now = places_of(last_);
    for (size_t k = 0; k < former_.size(); k++) {
      if (now.count(key_of(former_[k])) > 0) continue;
      ended.push_back(former_[k]);
      places.push_back(static_cast<int64_t>(k));
    }
    const hgrid::View<int64_t> found = former_keyed_ ? history_.ended_keys().places : history_.ended().places;
    require(std::equal(found.begin(), found.end(), places.begin(), places.end()), "other contacts have ended");
    require(equal(former_keyed_ ? list_of(history_.ended_keys().keys) : widened(history_.ended().pairs), ended),
            "ended contacts are called otherwise");
  }

  // One contact stands in the list once more, anywhere: the text names both places, and nothing changes.
  void refuse() {
    const hg_contact_key again = next_[rng_.below(next_.size())];
    const size_t at = rng_.below(next_.size() + 1);
    next_.insert(next_.begin() + static_cast<ptrdiff_t>(at), again);
    std::vector<size_t> places;
    for (size_t k = 0; k < next_.size(); k++) {
      if (key_of(next_[k]) == key_of(again)) places.push_back(k);
    }
    const hg_status status = status_of([&] { rng_.chance(0.5) ? static_cast<void>(give()) : give_restored(); });
    require(status == HG_ERR_ARGUMENT, "a contact that comes twice was not refused");
    const auto place = [&](size_t which) { return "[" + std::to_string(places[which]) + "]"; };
    const std::string text = hg_last_error();
    require(text.find(place(1) + " = (" + std::to_string(again.a)) != std::string::npos &&
                text.find(" is already listed as ") != std::string::npos && text.find(place(0)) != std::string::npos,
            text + " does not name places " + place(0) + " and " + place(1));
    require_remembered();
    require_ended();
  }

  Rng rng_;
  int id_bits_;
  bool hub_;            // most pairs share one particle
  double keyed_share_;  // of the lists
  bool far_;            // keys have numbers beyond 32 bits
  bool keyed_ = false, last_keyed_ = false, former_keyed_ = false, matched_ = false;
  hgrid::History history_;
  List last_, next_, former_;
};

void any_lists(void **) {
  assert_true(sweep(300, [](uint64_t seed) { Walk(seed).run(30); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_lists)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
