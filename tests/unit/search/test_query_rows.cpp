// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Rows in ascending order whatever their length; what a thread keeps of many; failures in the middle.
#include "src/search/query_rows.hpp"
#include "tests/unit/search/stored.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

namespace {

using namespace hgtest;

void rows_ascend(void **) {
  assert_true(sweep(500, [](uint64_t seed) {
    Rng rng(seed);
    hg::Memory memory(hg::system_allocator());
    hg::Buffer<int32_t> ids(memory);
    const size_t before = rng.below(3), count = rng.below(80);
    const bool repeated = rng.chance(0.5);
    std::set<int32_t> expected;
    ids.grow(before + count);
    for (size_t k = 0; k < before + count; k++) {
      ids[k] = static_cast<int32_t>(rng.below(repeated ? 40 : 2147483648u));
      if (k < before) continue;
      while (!expected.insert(ids[k]).second && !repeated) ids[k]++;
    }
    const int32_t first = before > 0 ? ids[0] : 0;
    const size_t end = hg::ascend_row(ids, before, before + count, repeated);
    require(end - before == expected.size(), "%zu of %zu ids", end - before, expected.size());
    require(std::equal(expected.begin(), expected.end(), ids.data() + before), "another order");
    require(before == 0 || ids[0] == first, "what stood there before");
  }));
}

// Query k finds k, k + 1 and so on; `fail_at` finds no memory.
class Counting final : public hg::RowSource {
 public:
  Counting(size_t count, size_t length, size_t fail_at = SIZE_MAX)
      : count_(count), length_(length), fail_at_(fail_at) {}
  size_t count() const override { return count_; }
  // Backwards along x, far outside the particles, or nowhere.
  void find_center(size_t k, double *center) const override {
    center[0] = -static_cast<double>(k);
    center[1] = k % 2 == 0 ? 0 : 1e300;
    center[2] = k % 3 == 0 ? 0 : std::numeric_limits<double>::quiet_NaN();
  }
  size_t find(size_t k, hg::Buffer<int32_t> &ids, size_t count) const override {
    if (k == fail_at_) hg::fail(HG_ERR_MEMORY, "query %zu", k);
    ids.grow(count + length_);
    for (size_t n = 0; n < length_; n++) ids[count + n] = static_cast<int32_t>(k + n);
    return count + length_;
  }

 private:
  size_t count_, length_, fail_at_;
};

void require_counted(const hg::QueryRows &rows, size_t count, size_t length) {
  for (size_t k = 0; k < count; k++) {
    require(rows.offsets()[k] == static_cast<int64_t>(k * length), "row %zu begins elsewhere", k);
    require(rows.ids()[k * length + length - 1] == static_cast<int32_t>(k + length - 1), "row %zu is another", k);
  }
  require(rows.offsets()[count] == static_cast<int64_t>(count * length), "the end of the rows");
}

void memory_is_bounded_and_failures_pass(void **) {
  assert_true(sweep(2, [](uint64_t seed) {
    CrowdShape shape;
    shape.count = 100;
    const int threads = 1 + static_cast<int>(seed % 2);
    const Stored stored(seed, shape, threads);
    const hg::BuiltGrid grid{stored.crowd.store, stored.crowd.overlap, stored.crowd.index, stored.candidates, threads};
    hg::QueryRows rows;
    rows.find(grid, Counting(2000, 3000));
    require_counted(rows, 2000, 3000);
    require(rows.kept_bytes() > hg::QueryRows::kMostKept, "the test needs larger rows");
    rows.find(grid, Counting(1000, 3));
    require_counted(rows, 1000, 3);
    require(rows.kept_bytes() < 100000, "%lld bytes are kept", static_cast<long long>(rows.kept_bytes()));
    require_refused("a failing query", HG_ERR_MEMORY, "query 700", [&] { rows.find(grid, Counting(1000, 3, 700)); });
    rows.find(grid, Counting(0, 1));
    require_counted(rows, 0, 1);
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(rows_ascend), cmocka_unit_test(memory_is_bounded_and_failures_pass)};
  return cmocka_run_group_tests_name("query_rows", tests, nullptr, nullptr);
}
