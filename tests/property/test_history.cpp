// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Contact histories against a std::map from pairs to places, through lists that grow, shrink, change their order, take
// ids from anywhere, and sometimes hold a pair twice.
#include "tests/support/compare.hpp"
#include "tests/support/rng.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace {

using namespace hgtest;

using List = std::vector<hg_pair>;
using Places = std::map<std::pair<int32_t, int32_t>, int64_t>;

Places places_of(const List &pairs) {
  Places places;
  for (size_t k = 0; k < pairs.size(); k++) {
    places.insert({{pairs[k].a, pairs[k].b}, static_cast<int64_t>(k)});
  }
  return places;
}

class Walk {
 public:
  explicit Walk(uint64_t seed) : rng_(seed), id_bits_(rng_.integer(4, 32)), hub_(rng_.chance(0.2)) {}

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
  hg_pair any_pair() { return {hub_ && rng_.chance(0.7) ? 7 : any_id(), any_id()}; }

  // The next list: that of the last step with some pairs gone, some new, parts of it moved, or all mixed up.
  void change() {
    next_.clear();
    Places seen;
    const double gone = rng_.chance(0.3) ? rng_.uniform() : 0.02, fresh = rng_.chance(0.3) ? rng_.uniform() : 0.02;
    const auto append = [&](const hg_pair &pair) {
      if (seen.insert({{pair.a, pair.b}, 0}).second) next_.push_back(pair);
    };
    for (const hg_pair &pair : last_) {
      if (!rng_.chance(gone)) append(pair);
      if (rng_.chance(fresh)) append(any_pair());
    }
    for (int k = rng_.integer(0, last_.size() < 100 ? 200 : 5); k > 0; k--) append(any_pair());
    if (rng_.chance(0.3)) {
      const auto middle = next_.begin() + static_cast<ptrdiff_t>(rng_.below(next_.size() + 1));
      std::rotate(next_.begin(), middle, next_.end());
    }
    if (rng_.chance(0.3)) {
      for (size_t k = next_.size(); k > 1; k--) std::swap(next_[k - 1], next_[rng_.below(k)]);
    }
  }

  void update() {
    const Places places = places_of(last_);
    const hgrid::View<int64_t> previous = history_.update(next_.size(), next_.data());
    std::vector<int64_t> old_items(last_.size()), items(next_.size(), -1);
    for (size_t k = 0; k < last_.size(); k++) old_items[k] = static_cast<int64_t>(k) + 1;
    history_.carry(sizeof items[0], old_items.data(), items.data());
    for (size_t k = 0; k < next_.size(); k++) {
      const auto found = places.find({next_[k].a, next_[k].b});
      const int64_t expected = found == places.end() ? -1 : found->second;
      require(previous[k] == expected, "pair " + std::to_string(k) + " was at " + std::to_string(previous[k]) +
                                           " instead of " + std::to_string(expected));
      require(items[k] == expected + 1, "item " + std::to_string(k) + " is " + std::to_string(items[k]));
    }
    last_ = next_;
    require_remembered();
  }

  void restore() {
    history_.restore(next_.size(), next_.data());
    last_ = next_;
    require_remembered();
  }

  void clear() {
    history_.clear();
    last_.clear();
    require_remembered();
  }

  // One pair stands in the list once more, anywhere: the text names both places, and nothing changes.
  void refuse() {
    const hg_pair again = next_[rng_.below(next_.size())];
    const size_t at = rng_.below(next_.size() + 1);
    next_.insert(next_.begin() + static_cast<ptrdiff_t>(at), again);
    std::vector<size_t> places;
    for (size_t k = 0; k < next_.size(); k++) {
      if (next_[k].a == again.a && next_[k].b == again.b) places.push_back(k);
    }
    const bool update = rng_.chance(0.5);
    const hg_status status = status_of([&] {
      update ? static_cast<void>(history_.update(next_.size(), next_.data()))
             : history_.restore(next_.size(), next_.data());
    });
    require(status == HG_ERR_ARGUMENT, "a pair that comes twice was not refused");
    const std::string text = "pairs[" + std::to_string(places[1]) + "] = (" + std::to_string(again.a) + ", " +
                             std::to_string(again.b) + ") is already listed as pairs[" + std::to_string(places[0]) +
                             "]";
    require(text == hg_last_error(), "\"" + std::string(hg_last_error()) + "\" instead of \"" + text + "\"");
    require_remembered();
  }

  void require_remembered() {
    const hgrid::View<hg_pair> pairs = history_.pairs();
    require(std::equal(pairs.begin(), pairs.end(), last_.begin(), last_.end(), pair_equal),
            "another list is remembered");
  }

  Rng rng_;
  int id_bits_;
  bool hub_;  // most pairs share one particle
  hgrid::History history_;
  List last_, next_;
};

void any_lists(void **) {
  assert_true(sweep(300, [](uint64_t seed) { Walk(seed).run(30); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_lists)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
