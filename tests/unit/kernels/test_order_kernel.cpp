// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The order kernels of every instruction set that this machine runs against std::sort: rows of all lengths, however
// their partners lie, and ids at the ends of their range.
#include "tests/unit/kernels/kernel_sets.hpp"
#include "tests/unit/same_pairs.hpp"

#include <limits>

namespace {

using namespace hgtest;

constexpr int32_t kLeastId = std::numeric_limits<int32_t>::min();
constexpr hg_pair kUntouched{-7, -7};

enum class Lie { kAscending, kDescending, kShuffled, kTwins };

// Rows of partners, and the pairs that they stand for.
class Rows {
 public:
  Rows(Rng &rng, int32_t first_id, int32_t id_offset) : rng_(rng), first_id_(first_id), id_offset_(id_offset) {}

  void add(uint32_t count, Lie lie) {
    std::vector<uint32_t> row(count);
    const uint32_t largest = std::numeric_limits<int32_t>::max() - static_cast<uint32_t>(id_offset_);
    for (uint32_t &b : row)
      b = rng_.chance(0.02) ? largest : static_cast<uint32_t>(rng_.below(largest) >> rng_.integer(0, 31));
    if (lie == Lie::kTwins) {
      for (uint32_t k = 1; k < count; k += 2) row[k] = row[k - 1];
    }
    std::vector<uint32_t> ascending = row;
    std::sort(ascending.begin(), ascending.end());
    if (lie == Lie::kAscending || count > hg::kMostSorted) row = ascending;
    if (lie == Lie::kDescending && count <= hg::kMostSorted) row.assign(ascending.rbegin(), ascending.rend());
    const auto a = static_cast<int32_t>(first_id_ + static_cast<int64_t>(end_.size()));
    partners_.insert(partners_.end(), row.begin(), row.end());
    end_.push_back(static_cast<uint32_t>(partners_.size()));
    for (const uint32_t b : ascending) {
      expected_.push_back({a, static_cast<int32_t>(b + static_cast<uint32_t>(id_offset_))});
    }
  }

  void check() {
    std::vector<uint32_t> partners = partners_;
    for (size_t k = 0; k < hg::kPadding; k++) partners.push_back(static_cast<uint32_t>(rng_.below(3)));
    for (const hg::KernelSet *set : kernel_sets()) {
      Pairs found(expected_.size() + hg::kPadding + 8, kUntouched);
      const hg_pair *end = set->order({partners.data(), end_.data(), end_.size(), first_id_, id_offset_}, found.data());
      require(end == found.data() + expected_.size(), "%s: %td pairs instead of %zu", set->name, end - found.data(),
              expected_.size());
      for (size_t k = expected_.size() + hg::kPadding; k < found.size(); k++) {
        require(pair_equal(found[k], kUntouched), "%s: wrote %zu behind the end", set->name, k - expected_.size());
      }
      found.resize(expected_.size());
      require_pairs(set->name, found, expected_);
    }
  }

 private:
  Rng &rng_;
  int32_t first_id_, id_offset_;
  std::vector<uint32_t> partners_, end_;
  Pairs expected_;
};

constexpr Lie kLies[] = {Lie::kAscending, Lie::kDescending, Lie::kShuffled, Lie::kTwins};

// One row alone, so that all it reads and writes behind its end is behind the list.
void each_length(void **) {
  assert_true(sweep(101, [](uint64_t seed) {
    Rng rng(seed);
    for (const Lie lie : kLies) {
      for (int n = 0; n < 20; n++) {
        Rows rows(rng, 0, rng.integer(0, 1));
        rows.add(static_cast<uint32_t>(seed), lie);
        rows.check();
      }
    }
  }));
}

void many_rows(void **) {
  assert_true(sweep(200, [](uint64_t seed) {
    Rng rng(seed);
    const int most = 1 << rng.integer(0, 7);
    Rows rows(rng, rng.chance(0.5) ? kLeastId : rng.integer(-1000, 1000), rng.chance(0.5) ? kLeastId : 1);
    const uint64_t count = rng.below(300);
    for (uint64_t n = 0; n < count; n++) {
      rows.add(static_cast<uint32_t>(rng.integer(0, most)), kLies[rng.below(std::size(kLies))]);
    }
    rows.check();
  }));
}

// Every order of up to eight partners.
void all_orders(void **) {
  assert_true(holds(0, [](uint64_t) {
    for (uint32_t count = 0; count <= 8; count++) {
      std::vector<uint32_t> row(count + hg::kPadding);
      for (uint32_t k = 0; k < count; k++) row[k] = k;
      do {
        for (const hg::KernelSet *set : kernel_sets()) {
          hg_pair found[8 + hg::kPadding];
          set->order({row.data(), &count, 1, 5, 0}, found);
          for (int32_t k = 0; k < static_cast<int32_t>(count); k++) {
            require(pair_equal(found[k], {5, k}), "%s: partner %d of %u", set->name, k, count);
          }
        }
      } while (std::next_permutation(row.begin(), row.begin() + count));
    }
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(each_length), cmocka_unit_test(many_rows), cmocka_unit_test(all_orders)};
  return cmocka_run_group_tests_name("order_kernel", tests, nullptr, nullptr);
}
