/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_set_group_pair: which groups meet. */
#include "tests/support/failing_alloc.h"
#include "tests/support/two_pairs.h"

static const int32_t kGroups[4] = {0, 1, 1, 1};

static hg_grid *make_grouped(void) {
  hg_grid *grid = make_grid(NULL, 4, kStart, kRadii);
  assert_ok(hg_set_groups(grid, 4, kGroups));
  return grid;
}

TEST(both_ways_and_back) {
  hg_grid *grid = make_grouped();
  assert_pairs(grid, kStartPairs, 2);
  assert_ok(hg_set_group_pair(grid, 0, 1, 0));
  assert_pairs(grid, kStartPairs + 1, 1);
  assert_ok(hg_set_group_pair(grid, 1, 0, 1));
  assert_pairs(grid, kStartPairs, 2);
  assert_ok(hg_set_group_pair(grid, 1, 1, 0));
  assert_pairs(grid, kStartPairs, 1);
  hg_destroy(grid);
}

/* Nobody was told of groups: all are in group 0. */
TEST(a_group_that_does_not_meet_itself) {
  hg_grid *grid = make_grid(NULL, 4, kStart, kRadii);
  assert_ok(hg_set_group_pair(grid, 0, 0, 0));
  assert_pairs(grid, NULL, 0);
  hg_destroy(grid);
}

/* Spheres meet particles of all groups. */
TEST(spheres_know_no_groups) {
  const double center[3] = {10.5, 0, 0};
  const int32_t *ids;
  size_t count;
  hg_grid *grid = make_grouped();
  assert_ok(hg_set_group_pair(grid, 1, 1, 0));
  assert_ok(hg_query_sphere(grid, center, 0, &ids, &count));
  assert_int_equal(2, count);
  hg_destroy(grid);
}

TEST(outlives_the_particles) {
  hg_grid *grid = make_grouped();
  assert_ok(hg_set_group_pair(grid, 1, 1, 0));
  assert_ok(hg_clear(grid));
  assert_ok(hg_set(grid, 4, kMoved, kRadii));
  assert_pairs(grid, kMovedPairs, 2);
  assert_ok(hg_set_groups(grid, 4, kGroups));
  assert_pairs(grid, kMovedPairs, 1);
  hg_destroy(grid);
}

TEST(bad_ones_are_refused) {
  hg_grid *grid = make_grouped();
  assert_status(HG_ERR_ARGUMENT, hg_set_group_pair(grid, -1, 0, 0));
  assert_error_names("group_a = -1");
  assert_status(HG_ERR_ARGUMENT, hg_set_group_pair(grid, 0, 64, 0));
  assert_error_names("group_b = 64");
  assert_status(HG_ERR_ARGUMENT, hg_set_group_pair(grid, 0, 1, 2));
  assert_error_names("interacts = 2");
  assert_status(HG_ERR_NULL, hg_set_group_pair(NULL, 0, 1, 0));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

static hg_status part(hg_grid *grid) { return hg_set_group_pair(grid, 0, 0, 0); }

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(part); }

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(both_ways_and_back),     cmocka_unit_test(a_group_that_does_not_meet_itself),
      cmocka_unit_test(spheres_know_no_groups), cmocka_unit_test(outlives_the_particles),
      cmocka_unit_test(bad_ones_are_refused),   cmocka_unit_test(refused_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
