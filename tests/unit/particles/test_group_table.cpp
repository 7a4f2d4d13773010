// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Classes of groups: two groups share one exactly if they meet the same groups of those present.
#include "src/particles/group_table.hpp"
#include "tests/unit/checks.hpp"

#include <cstddef>

namespace {

using namespace hgtest;

void check_table(uint64_t seed) {
  Rng rng(seed);
  hg::GroupTable table;
  bool meets[HG_MAX_GROUPS][HG_MAX_GROUPS];
  for (auto &row : meets) {
    for (bool &entry : row) entry = true;
  }
  const int groups = rng.chance(0.5) ? HG_MAX_GROUPS : 1 + static_cast<int>(rng.below(6));
  for (size_t change = rng.below(40); change > 0; change--) {
    const int a = rng.integer(0, groups - 1), b = rng.integer(0, groups - 1);
    meets[a][b] = meets[b][a] = rng.chance(0.4);
    table.set(a, b, meets[a][b]);
  }
  hg::GroupSet present = 0;
  for (int g = 0; g < groups; g++) present |= rng.chance(0.7) ? hg::only(g) : 0;

  const hg::GroupClasses classes = table.classes(present);
  require(classes.count >= 1 && classes.count <= groups, "%d classes of %d groups", classes.count, groups);
  const auto is_present = [&](int g) { return hg::contains(present, g); };
  for (int a = 0; a < groups; a++) {
    for (int b = 0; b < groups; b++) {
      require(table.meet(a, b) == meets[a][b], "groups %d and %d", a, b);
      if (!is_present(a) || !is_present(b)) continue;
      bool same = true;
      for (int g = 0; g < groups; g++) same = same && (!is_present(g) || meets[a][g] == meets[b][g]);
      require(same == (classes.of_group[a] == classes.of_group[b]), "classes of %d and %d", a, b);
      require(classes.meet(classes.of_group[a], classes.of_group[b]) == meets[a][b], "whether %d and %d meet", a, b);
    }
  }
  if (present == 0) require(classes.count == 1 && !classes.meet(0, 0), "nobody meets");
}

void random_tables(void **) { assert_true(sweep(2000, check_table)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(random_tables)};
  return cmocka_run_group_tests_name("group_table", tests, nullptr, nullptr);
}
