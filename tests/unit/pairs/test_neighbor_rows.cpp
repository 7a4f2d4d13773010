// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// NeighborRows against rows gathered in sets.
#include "src/pairs/neighbor_rows.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/pairs/any_pairs.hpp"

#include <algorithm>
#include <set>
#include <vector>

namespace {

using namespace hgtest;
using hg::NeighborRows;

using Rows = std::vector<std::set<int32_t>>;

void require_rows(NeighborRows &got, const Rows &expected) {
  require(got.offsets()[0] == 0, "the first offset is %lld", static_cast<long long>(got.offsets()[0]));
  for (size_t row = 0; row < expected.size(); row++) {
    const int64_t begin = got.offsets()[row], end = got.offsets()[row + 1];
    require(end - begin == static_cast<int64_t>(expected[row].size()), "row %zu has %lld neighbours", row,
            static_cast<long long>(end - begin));
    require(std::equal(expected[row].begin(), expected[row].end(), got.neighbors() + begin), "row %zu differs", row);
  }
}

void check_any(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  NeighborRows rows(memory);
  for (int pass = 0; pass < 3; pass++) {
    const int count = rng.integer(0, 300);
    const int32_t base = rng.integer(0, 1);
    std::vector<hg_pair> pairs = any_pairs(rng, count, base);
    Rows half(static_cast<size_t>(count)), full(static_cast<size_t>(count));
    for (const hg_pair &p : pairs) {
      half[static_cast<size_t>(p.a - base)].insert(p.b);
      full[static_cast<size_t>(p.a - base)].insert(p.b);
      full[static_cast<size_t>(p.b - base)].insert(p.a);
    }
    for (const bool ascending : {false, true}) {
      rows.build(pairs.data(), pairs.size(), half.size(), base, HG_FULL, ascending);
      require_rows(rows, full);
      rows.build(pairs.data(), pairs.size(), half.size(), base, HG_HALF, ascending);
      require_rows(rows, half);
      std::sort(pairs.begin(), pairs.end(), [](hg_pair p, hg_pair q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
    }
  }
}

void any_pairs_in_rows(void **) { assert_true(sweep(200, check_any)); }

void no_rows(void **) {
  assert_true(holds(0, [](uint64_t) {
    hg::Memory memory(hg::system_allocator());
    NeighborRows rows(memory);
    for (const int32_t list : {HG_HALF, HG_FULL}) {
      rows.build(nullptr, 0, 0, 0, list, true);
      require(rows.offsets()[0] == 0 && rows.neighbors() != nullptr, "empty rows must be readable");
    }
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_pairs_in_rows), cmocka_unit_test(no_rows)};
  return cmocka_run_group_tests_name("neighbor_rows", tests, nullptr, nullptr);
}
