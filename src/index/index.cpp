// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/index/index.hpp"

namespace hg {

void Index::lay_levels(const LevelPlan &plan, const GroupClasses &of_groups) {
  insertion_levels = plan.level_count;
  classes = of_groups;
  level_count = insertion_levels * classes.count;
  level_room.require(static_cast<size_t>(level_count));
  levels = level_room.data();
  for (int h = 0; h < insertion_levels; h++) {
    for (int c = 0; c < classes.count; c++) {
      IndexLevel &level = levels[level_number(h, c)] = IndexLevel{};
      level.plan = plan.levels[h];
      level.insertion_level = h;
      level.group_class = c;
    }
  }
}

bool Index::searches(int h, int k) const {
  const IndexLevel &from = levels[h], &to = levels[k];
  if (from.is_empty() || to.is_empty() || !classes.meet(from.group_class, to.group_class)) return false;
  if (from.insertion_level != to.insertion_level) return from.insertion_level > to.insertion_level;
  const uint32_t here = from.end - from.begin, there = to.end - to.begin;
  return h == k || here < there || (here == there && h > k);
}

}  // namespace hg
