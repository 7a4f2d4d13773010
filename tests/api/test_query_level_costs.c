/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_query_level_costs: what the rule expects of each number of levels (Eq. 7). */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

#include <math.h>

/* Sizes 1, 2, 4, 8 in a box of 64^3. */
static hg_grid *make_four_sizes(hg_grid_def *def) {
  const double centers[12] = {8, 8, 8, 24, 24, 24, 40, 40, 40, 56, 56, 56}, radii[4] = {1, 2, 4, 8};
  int k;
  for (k = 0; k < 3; ++k) def->box_max[k] = 64;
  return make_grid(def, 4, centers, radii);
}

TEST(costs_follow_eq_7) {
  const double overheads[3] = {-1, 0, 2.5};
  int k;
  for (k = 0; k < 3; ++k) {
    hg_grid_def def = hg_default_grid_def();
    const double overhead = overheads[k] < 0 ? 0.3 : overheads[k];
    const hg_level_cost *costs;
    hg_grid *grid;
    size_t count, i;
    def.level_rule = HG_LEVELS_PAPER;
    def.cell_overhead = overheads[k];
    grid = make_four_sizes(&def);
    assert_ok(hg_query_level_costs(grid, &costs, &count));
    assert_true(count >= 4);
    for (i = 0; i < count; ++i) {
      assert_int_equal(i + 1, costs[i].level_count);
      if (costs[i].reachable) {
        const double expected = costs[i].level_count * (costs[i].occupancy + overhead);
        assert_true(fabs(costs[i].cost - expected) <= 1e-12 * expected);
      } else {
        assert_true(costs[i].occupancy == 0 && costs[i].cost == 0);
      }
    }
    /* One level of cells of edge 16 holds all four: m = 4 (16 / 64)^3. Each size alone: m = that of the largest. */
    assert_true(fabs(costs[0].occupancy - 4 / 64.0) <= 1e-9);
    assert_int_equal(1, costs[3].reachable);
    assert_true(fabs(costs[3].occupancy - 1 / 64.0) <= 1e-9);
    for (i = 4; i < count; ++i) assert_int_equal(0, costs[i].reachable);
    hg_destroy(grid);
  }
}

/* The grid is built with the cheapest reachable number of levels. */
TEST(the_cheapest_is_chosen) {
  int32_t rule;
  for (rule = HG_LEVELS_AUTO; rule <= HG_LEVELS_PAPER; ++rule) {
    hg_grid_def def = hg_default_grid_def();
    const hg_level_cost *costs;
    const hg_level *levels;
    size_t count, level_count, i, best = 0;
    hg_grid *grid;
    def.level_rule = rule;
    grid = make_four_sizes(&def);
    assert_ok(hg_query_levels(grid, &levels, &level_count));
    assert_ok(hg_query_level_costs(grid, &costs, &count));
    for (i = 1; i < count; ++i) {
      if (costs[i].reachable && costs[i].cost < costs[best].cost) best = i;
    }
    assert_int_equal(costs[best].level_count, level_count);
    hg_destroy(grid);
  }
}

TEST(user_levels_have_no_costs) {
  const double size = 16;
  hg_grid_def def = user_levels(&size, 1);
  hg_grid *grid = make_four_sizes(&def);
  const hg_level_cost *costs;
  size_t count = 77;
  assert_ok(hg_query_level_costs(grid, &costs, &count));
  assert_int_equal(0, count);
  hg_destroy(grid);
}

TEST(null_is_refused) {
  hg_grid *grid = make_chain(NULL);
  const hg_level_cost *costs;
  size_t count;
  assert_status(HG_ERR_NULL, hg_query_level_costs(NULL, &costs, &count));
  assert_status(HG_ERR_NULL, hg_query_level_costs(grid, NULL, &count));
  assert_status(HG_ERR_NULL, hg_query_level_costs(grid, &costs, NULL));
  hg_destroy(grid);
}

static hg_status query_again(hg_grid *grid) {
  const hg_level_cost *costs;
  size_t count;
  return hg_query_level_costs(grid, &costs, &count);
}

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(query_again); }

TEST(no_memory) { assert_true(refuse_each_allocation_on_chain(query_again) > 0); }

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(costs_follow_eq_7),         cmocka_unit_test(the_cheapest_is_chosen),
      cmocka_unit_test(user_levels_have_no_costs), cmocka_unit_test(null_is_refused),
      cmocka_unit_test(refused_inside_a_visitor),  cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
