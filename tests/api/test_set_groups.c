/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_set_groups: who is in which group, and who is absent; all or nothing. tests/property/lives.cpp compares the pairs
 * of any groups with brute force. */
#include "tests/support/failing_alloc.h"
#include "tests/support/two_pairs.h"

/* Of the chain only links between present neighbours are left. */
static const int32_t kHoles[CHAIN_COUNT] = {0, 0, -1, 0, 0, 0, -1, -1, 0};
static const hg_pair kLeft[3] = {{0, 1}, {3, 4}, {4, 5}};

static hg_status set_holes(hg_grid *grid) { return hg_set_groups(grid, CHAIN_COUNT, kHoles); }

TEST(absent_ones_are_in_no_query) {
  const double center[3] = {2, 0, 0};
  const int32_t *ids, *neighbors;
  const int64_t *offsets;
  size_t count;
  hg_grid *grid = make_chain(NULL);
  assert_ok(set_holes(grid));
  assert_pairs(grid, kLeft, 3);
  assert_ok(hg_query_neighbors(grid, HG_FULL, &offsets, &neighbors));
  assert_int_equal(6, offsets[CHAIN_COUNT]);
  assert_int_equal(offsets[2], offsets[3]); /* an empty row */
  assert_ok(hg_query_sphere(grid, center, 1.0, &ids, &count));
  assert_int_equal(2, count);
  assert_int_equal(1, ids[0]);
  assert_int_equal(3, ids[1]);
  assert_ok(hg_query_order(grid, &ids, &count));
  assert_int_equal(CHAIN_COUNT, count); /* there they stand */
  assert_int_equal(CHAIN_COUNT, stats_of(grid).particle_count);
  assert_ok(hg_set_groups(grid, 0, NULL));
  assert_chain(grid, 0);
  hg_destroy(grid);
}

TEST(all_may_be_absent) {
  const int32_t absent[4] = {-1, -1, -1, -1}, one[4] = {-1, 0, -1, -1};
  hg_grid *grid = make_grid(NULL, 4, kStart, kRadii);
  assert_ok(hg_set_groups(grid, 4, absent));
  assert_pairs(grid, NULL, 0);
  assert_ok(hg_set_groups(grid, 4, one));
  assert_pairs(grid, NULL, 0);
  hg_destroy(grid);
}

/* Parked at one place, or beyond all bounds, where they would spoil the resolution of the search. */
TEST(absent_ones_may_lie_anywhere) {
  const int32_t groups[4] = {0, 0, -1, -1};
  double centers[12];
  hg_grid *grid = make_grid(NULL, 4, kStart, kRadii);
  assert_ok(hg_set_groups(grid, 4, groups));
  memcpy(centers, kStart, sizeof centers);
  centers[6] = centers[9] = 1e300;
  assert_ok(hg_move(grid, 4, centers, NULL));
  assert_pairs(grid, kStartPairs, 1);
  memcpy(centers + 6, kStart, 3 * sizeof *centers);
  memcpy(centers + 9, kStart, 3 * sizeof *centers);
  assert_ok(hg_move(grid, 4, centers, NULL));
  assert_pairs(grid, kStartPairs, 1);
  hg_destroy(grid);
}

/* What came later is in group 0; what went takes its group along; another number of particles forgets. */
TEST(groups_follow_their_particles) {
  const int32_t groups[4] = {-1, 0, 0, 0}, gone = 1;
  const double near_0[3] = {0, 0.5, 0}, radius = 0.6;
  const hg_pair left[2] = {{1, 4}, {2, 3}};
  hg_grid *grid = make_grid(NULL, 4, kStart, kRadii);
  assert_ok(hg_set_groups(grid, 4, groups));
  assert_ok(hg_insert(grid, 1, near_0, &radius));
  assert_pairs(grid, left, 2);
  assert_ok(hg_remove(grid, 1, &gone));
  assert_pairs(grid, left + 1, 1);
  assert_ok(hg_set(grid, 4, kStart, kRadii)); /* as many as there were: the first is still absent */
  assert_pairs(grid, kStartPairs + 1, 1);
  assert_ok(hg_set(grid, 3, kStart, kRadii));
  assert_pairs(grid, kStartPairs, 1);
  assert_ok(hg_set_groups(grid, 3, groups));
  assert_ok(hg_clear(grid));
  assert_ok(hg_insert(grid, 4, kStart, kRadii));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

/* Told in each step, groups that stay leave stored candidates in use; others do not. */
TEST(stored_candidates) {
  const int32_t groups[4] = {0, 5, 0, 5}, others[4] = {0, -1, 0, 5};
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  int step;
  def.skin = 0.5;
  grid = make_grid(&def, 4, kStart, kRadii);
  for (step = 0; step < 3; ++step) {
    assert_ok(hg_move(grid, 4, kStart, NULL));
    assert_ok(hg_set_groups(grid, 4, groups));
    assert_pairs(grid, kStartPairs, 2);
  }
  assert_int_equal(1, stats_of(grid).search_count);
  assert_ok(hg_set_groups(grid, 4, others));
  assert_pairs(grid, kStartPairs + 1, 1);
  assert_int_equal(2, stats_of(grid).search_count);
  hg_destroy(grid);
}

TEST(bad_ones_are_refused) {
  const int32_t good[4] = {0, 63, 1, -1}, negative[4] = {0, 0, -2, 0}, large[4] = {0, 0, 0, 64};
  hg_grid *grid = make_grid(NULL, 4, kStart, kRadii);
  assert_ok(hg_set_groups(grid, 4, good));
  assert_pairs(grid, kStartPairs, 1);
  assert_status(HG_ERR_ARGUMENT, hg_set_groups(grid, 4, negative));
  assert_error_names("groups[2] = -2");
  assert_status(HG_ERR_ARGUMENT, hg_set_groups(grid, 4, large));
  assert_error_names("groups[3] = 64");
  assert_status(HG_ERR_ARGUMENT, hg_set_groups(grid, 3, good));
  assert_error_names("count is 3");
  assert_status(HG_ERR_NULL, hg_set_groups(NULL, 4, good));
  assert_pairs(grid, kStartPairs, 1);
  hg_destroy(grid);
}

/* Two classes that meet each other alone leave the chain as it is. */
static hg_status set_and_query(hg_grid *grid) {
  const int32_t in_turns[CHAIN_COUNT] = {1, 2, 1, 2, 1, 2, 1, 2, 1};
  const hg_pair *pairs;
  size_t count;
  hg_status status = hg_set_groups(grid, CHAIN_COUNT, in_turns);
  if (status == HG_OK) status = hg_set_group_pair(grid, 1, 1, 0);
  if (status == HG_OK) status = hg_set_group_pair(grid, 2, 2, 0);
  return status != HG_OK ? status : hg_query_pairs(grid, &pairs, &count);
}

TEST(no_memory) { assert_true(refuse_each_allocation_on_chain(set_and_query) > 0); }
TEST(refused_inside_a_visitor) { assert_refused_in_visitor(set_holes); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(absent_ones_are_in_no_query),
                                     cmocka_unit_test(all_may_be_absent),
                                     cmocka_unit_test(absent_ones_may_lie_anywhere),
                                     cmocka_unit_test(groups_follow_their_particles),
                                     cmocka_unit_test(stored_candidates),
                                     cmocka_unit_test(bad_ones_are_refused),
                                     cmocka_unit_test(no_memory),
                                     cmocka_unit_test(refused_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
