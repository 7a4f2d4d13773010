// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which levels search which: of two that hold particles and meet, exactly one searches the other.
#include "src/index/index.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/domains.hpp"

namespace {

using namespace hgtest;

void check_levels(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  hg::Index index(memory, open_space(3), hg::Interaction{});
  hg::LevelPlan plan;
  plan.level_count = rng.integer(1, 5);
  hg::GroupTable table;
  const int groups = rng.integer(1, 6);
  for (int change = 0; change < 8; change++) {
    table.set(rng.integer(0, groups - 1), rng.integer(0, groups - 1), rng.chance(0.5));
  }
  index.lay_levels(plan, table.classes((hg::GroupSet{1} << groups) - 1));
  require(index.level_count == plan.level_count * index.classes.count, "%d levels", index.level_count);
  uint32_t begin = 0;
  for (int h = 0; h < index.level_count; h++) {
    index.levels[h].begin = begin;
    index.levels[h].end = begin += static_cast<uint32_t>(rng.below(3));  // often as many as another one
  }
  for (int h = 0; h < index.level_count; h++) {
    const hg::IndexLevel &one = index.levels[h];
    require(index.level_number(one.insertion_level, one.group_class) == h, "the number of level %d", h);
    for (int k = 0; k < index.level_count; k++) {
      const hg::IndexLevel &other = index.levels[k];
      const bool meet = !one.is_empty() && !other.is_empty() && index.classes.meet(one.group_class, other.group_class);
      const int searches = (index.searches(h, k) ? 1 : 0) + (h != k && index.searches(k, h) ? 1 : 0);
      require(searches == (meet ? 1 : 0), "levels %d and %d are searched %d times", h, k, searches);
      if (index.searches(h, k)) require(one.insertion_level >= other.insertion_level, "a finer level searches");
    }
  }
}

void random_levels(void **) { assert_true(sweep(1000, check_levels)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(random_levels)};
  return cmocka_run_group_tests_name("level_pairs", tests, nullptr, nullptr);
}
