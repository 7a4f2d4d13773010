/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_move: new centres and radii in id order; all or nothing; no memory needed; with a skin, stored candidates hold
 * while particles move little. */
#include "tests/support/failing_alloc.h"
#include "tests/support/two_pairs.h"

#include <stdlib.h>
#include <string.h>

static hg_grid *make_start(const hg_grid_def *def) { return make_grid(def, 4, kStart, kRadii); }

TEST(pairs_follow_the_particles) {
  hg_grid *grid = make_start(NULL);
  assert_pairs(grid, kStartPairs, 2);
  assert_ok(hg_move(grid, 4, kMoved, NULL));
  assert_pairs(grid, kMovedPairs, 2);
  assert_ok(hg_move(grid, 4, kStart, kRadii));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

TEST(radii_change_when_given) {
  const double small[4] = {0.6, 0.6, 0.1, 0.1}, large[4] = {0.6, 0.6, 0.6, 100};
  const hg_pair all_with_3[4] = {{0, 1}, {0, 3}, {1, 3}, {2, 3}};
  hg_grid *grid = make_start(NULL);
  assert_ok(hg_move(grid, 4, kStart, small));
  assert_pairs(grid, kStartPairs, 1);
  assert_ok(hg_move(grid, 4, kStart, NULL));
  assert_pairs(grid, kStartPairs, 1);
  assert_ok(hg_move(grid, 4, kStart, large));
  assert_pairs(grid, all_with_3, 4);
  hg_destroy(grid);
}

/* Rows follow the live particles in ascending id. */
TEST(rows_skip_removed_particles) {
  const int32_t gone = 1;
  const double centers[9] = {0, 0, 0, 5, 0, 0, 1, 0, 0};
  const hg_pair expected[1] = {{0, 3}};
  hg_grid *grid = make_start(NULL);
  assert_ok(hg_remove(grid, 1, &gone));
  assert_status(HG_ERR_ARGUMENT, hg_move(grid, 4, kMoved, NULL));
  assert_ok(hg_move(grid, 3, centers, NULL));
  assert_pairs(grid, expected, 1);
  hg_destroy(grid);
}

TEST(empty_grid) {
  hg_grid *grid = make_empty(NULL);
  assert_ok(hg_move(grid, 0, NULL, NULL));
  assert_ok(hg_move(grid, 0, kStart, kRadii));
  assert_status(HG_ERR_ARGUMENT, hg_move(grid, 1, kStart, NULL));
  assert_pairs(grid, NULL, 0);
  hg_destroy(grid);
}

TEST(wrong_count_is_refused) {
  hg_grid *grid = make_start(NULL);
  assert_status(HG_ERR_ARGUMENT, hg_move(grid, 3, kMoved, NULL));
  assert_error_names("3");
  assert_error_names("4");
  assert_status(HG_ERR_ARGUMENT, hg_move(grid, 0, NULL, NULL));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

TEST(null_is_refused) {
  hg_grid *grid = make_start(NULL);
  assert_status(HG_ERR_NULL, hg_move(NULL, 4, kMoved, NULL));
  assert_status(HG_ERR_NULL, hg_move(grid, 4, NULL, kRadii));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

TEST(bad_values_change_nothing) {
  hg_grid *grid = make_start(NULL);
  int row;
  for (row = 0; row < 4; ++row) {
    refuse_value(grid, hg_move, 4, row, 0, not_a_number(), "nan");
    refuse_value(grid, hg_move, 4, row, 2, -infinity(), "-inf");
    refuse_value(grid, hg_move, 4, row, 3, -0.375, "-0.375");
    refuse_value(grid, hg_move, 4, row, 3, not_a_number(), "nan");
    refuse_value(grid, hg_move, 4, row, 3, infinity(), "inf");
  }
  hg_destroy(grid);
}

TEST(growth_beyond_the_box_is_refused) {
  const double grown[4] = {0.6, 0.6, 0.6, 9.5};
  const hg_grid_def def = periodic_axis(0, 20);
  hg_grid *grid = make_start(&def);
  assert_status(HG_ERR_ARGUMENT, hg_move(grid, 4, kMoved, grown));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

TEST(growth_beyond_the_user_cells_is_refused) {
  const double cell = 1.5, grown[4] = {0.6, 0.6, 0.6, 0.8};
  const hg_grid_def def = user_levels(&cell, 1);
  hg_grid *grid = make_start(&def);
  assert_status(HG_ERR_ARGUMENT, hg_move(grid, 4, kMoved, grown));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

TEST(too_far_outside_a_periodic_box) {
  double centers[12];
  const hg_grid_def def = periodic_axis(0, 20);
  hg_grid *grid = make_start(&def);
  memcpy(centers, kMoved, sizeof centers);
  centers[6] = 1e13;
  assert_status(HG_ERR_LIMIT, hg_move(grid, 4, centers, NULL));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

TEST(needs_no_memory) {
  hg_grid *grid;
  long long calls;
  failing_alloc_install();
  grid = make_start(NULL);
  assert_pairs(grid, kStartPairs, 2);
  calls = failing_alloc_books().calls;
  assert_ok(hg_move(grid, 4, kMoved, kRadii));
  assert_int_equal(calls, failing_alloc_books().calls);
  assert_pairs(grid, kMovedPairs, 2);
  hg_destroy(grid);
  failing_alloc_remove();
}

/* Enough particles for threads to be used, each rattling about its own place: cells, candidates and pairs change in
 * number from step to step, but not much. */
enum { SIDE = 28, CROWD = SIDE * SIDE * SIDE };

static void rattle(double *centers, unsigned *noise) {
  int i, k;
  for (i = 0; i < CROWD; ++i) {
    const int place[3] = {i % SIDE, i / SIDE % SIDE, i / (SIDE * SIDE)};
    for (k = 0; k < 3; ++k) {
      *noise = *noise * 1664525u + 1013904223u;
      centers[3 * i + k] = place[k] + 0.1 * ((double)(*noise >> 8) / (1 << 24) - 0.5);
    }
  }
}

static void steady(double skin, int threads, int32_t order) {
  double *centers = malloc(3 * CROWD * sizeof *centers), *radii = malloc(CROWD * sizeof *radii);
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  long long calls = 0;
  unsigned noise = 1;
  int step, i;
  for (i = 0; i < CROWD; ++i) radii[i] = 0.5;
  rattle(centers, &noise);
  def.skin = skin;
  def.thread_count = threads;
  def.pair_order = order;
  failing_alloc_install();
  grid = make_grid(&def, CROWD, centers, radii);
  for (step = 0; step < 14; ++step) {
    if (step == 7) calls = failing_alloc_books().calls;
    assert_true(pairs_in(grid) > CROWD);
    rattle(centers, &noise);
    assert_ok(hg_move(grid, CROWD, centers, step % 3 == 0 ? radii : NULL));
  }
  assert_int_equal(calls, failing_alloc_books().calls);
  hg_destroy(grid);
  failing_alloc_remove();
  free(centers);
  free(radii);
}

TEST(steps_need_no_memory_once_under_way) {
  int threads;
  for (threads = 1; threads <= 2; ++threads) {
    steady(0, threads, HG_ORDER_GRID);
    steady(0.3, threads, HG_ORDER_GRID);  /* always filtered */
    steady(0.05, threads, HG_ORDER_GRID); /* always searched anew */
    steady(0.3, threads, HG_ORDER_ID);
  }
}

/* What happened in the query after a step: a search, or a filtering of stored candidates. */
static void assert_step(hg_grid *grid, const double *centers, const double *radii, int64_t searches, int64_t filters) {
  assert_ok(hg_move(grid, 4, centers, radii));
  assert_ok(search(grid));
  assert_int_equal(searches, stats_of(grid).search_count);
  assert_int_equal(filters, stats_of(grid).filter_count);
  assert_true(stats_of(grid).stored_count > 0);
}

TEST(statistics_tell_searches_from_filters) {
  const double grown[4] = {0.6, 0.65, 0.6, 0.6}, more[4] = {0.6, 0.6, 0.6, 0.72};
  double centers[12];
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  def.skin = 0.2;
  grid = make_start(&def);
  assert_int_equal(0, stats_of(grid).stored_count);
  assert_pairs(grid, kStartPairs, 2);
  assert_int_equal(1, stats_of(grid).search_count);
  assert_int_equal(0, stats_of(grid).filter_count);
  assert_int_equal(2, stats_of(grid).stored_count);
  memcpy(centers, kStart, sizeof centers);
  centers[0] -= 0.09; /* of 0.1, half the skin */
  assert_step(grid, centers, NULL, 1, 1);
  assert_step(grid, kStart, NULL, 1, 2); /* back again: it is the distance that counts, not the way */
  centers[0] = -0.101;
  assert_step(grid, centers, NULL, 2, 2);
  assert_step(grid, centers, grown, 2, 3);
  centers[4] += 0.06; /* with its growth by 0.05 that is too far */
  assert_step(grid, centers, grown, 3, 3);
  assert_step(grid, centers, kRadii, 3, 4); /* shrinking is no motion */
  assert_step(grid, centers, more, 4, 4);
  assert_ok(search(grid));
  assert_int_equal(4, stats_of(grid).search_count); /* nothing has changed since */
  hg_destroy(grid);
}

TEST(no_skin_stores_nothing) {
  hg_grid *grid = make_start(NULL);
  assert_pairs(grid, kStartPairs, 2);
  assert_ok(hg_move(grid, 4, kStart, NULL));
  assert_pairs(grid, kStartPairs, 2);
  assert_int_equal(2, stats_of(grid).search_count);
  assert_int_equal(0, stats_of(grid).filter_count);
  assert_int_equal(0, stats_of(grid).stored_count);
  hg_destroy(grid);
}

/* Periodic boxes and user cells leave no room for the wider reach: the skin shrinks, or the cells widen. */
TEST(a_skin_is_never_an_error) {
  const double skins[] = {1e-300, 0.3, 3, 1e3, 1e308}, cell = 1.2;
  double centers[12];
  size_t k;
  for (k = 0; k < sizeof skins / sizeof skins[0]; ++k) {
    hg_grid_def def = user_levels(&cell, 1);
    hg_grid *grid;
    def.skin = skins[k];
    def.periodic[1] = 1;
    def.box_min[1] = -1.25;
    def.box_max[1] = 1.25; /* twice the reach, and 0.1 */
    grid = make_start(&def);
    assert_pairs(grid, kStartPairs, 2);
    memcpy(centers, kStart, sizeof centers);
    centers[1] = 2.5; /* the same place */
    assert_ok(hg_move(grid, 4, centers, NULL));
    assert_pairs(grid, kStartPairs, 2);
    assert_ok(hg_move(grid, 4, kMoved, NULL));
    assert_pairs(grid, kMovedPairs, 2);
    hg_destroy(grid);
  }
}

TEST(insert_remove_and_clear_make_candidates_stale) {
  const double near_0[3] = {0.5, 0, 0}, radius = 0.6;
  const hg_pair with_new[4] = {{0, 1}, {0, 4}, {1, 4}, {2, 3}}, without_1[2] = {{0, 4}, {2, 3}};
  const int32_t gone = 1;
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  def.skin = 0.5;
  grid = make_start(&def);
  assert_pairs(grid, kStartPairs, 2);
  assert_ok(hg_insert(grid, 1, near_0, &radius));
  assert_int_equal(0, stats_of(grid).stored_count);
  assert_pairs(grid, with_new, 4);
  assert_ok(hg_remove(grid, 1, &gone));
  assert_int_equal(0, stats_of(grid).stored_count);
  assert_pairs(grid, without_1, 2);
  assert_ok(hg_clear(grid));
  assert_int_equal(0, stats_of(grid).stored_count);
  assert_pairs(grid, NULL, 0);
  assert_int_equal(0, stats_of(grid).filter_count);
  hg_destroy(grid);
}

/* Every allocation of the first query with a skin fails once; so does every one of a search anew. */
static void start_with_skin(hg_grid **grid) {
  hg_grid_def def = periodic_axis(0, 20);
  def.skin = 0.5;
  def.thread_count = 2;
  *grid = make_start(&def);
}

static hg_status query(hg_grid **grid) { return search(*grid); }

static void has_start_pairs(hg_grid *grid) {
  assert_pairs(grid, kStartPairs, 2);
  assert_ok(hg_move(grid, 4, kMoved, NULL));
  assert_pairs(grid, kMovedPairs, 2);
}

TEST(every_allocation_with_skin_fails_once) {
  const alloc_scenario scenario = {start_with_skin, query, NULL, has_start_pairs};
  assert_true(refuse_each_allocation(&scenario) > 10);
}

/* Candidates, one of them across a face, are put in order of ids when they are filtered first after a motion. */
static void move_with_skin(hg_grid **grid) {
  const double ring[12] = {0, 0, 0, 1, 0, 0, 10, 0, 0, 19, 0, 0}, apart[12] = {0, 0, 0, 1.21, 0, 0, 10, 0, 0, 19, 0, 0};
  const hg_pair pairs[2] = {{0, 1}, {0, 3}};
  hg_grid_def def = periodic_axis(0, 20);
  def.skin = 0.5;
  def.pair_order = HG_ORDER_ID;
  *grid = make_grid(&def, 4, ring, kRadii);
  assert_pairs(*grid, pairs, 2);
  assert_ok(hg_move(*grid, 4, apart, NULL));
}

static void has_pair_across(hg_grid *grid) {
  const hg_pair pair = {0, 3};
  assert_pairs(grid, &pair, 1);
}

TEST(every_allocation_of_a_filter_fails_once) {
  const alloc_scenario looked_at = {move_with_skin, query, has_pair_across, has_pair_across};
  const alloc_scenario left_alone = {move_with_skin, query, NULL, has_pair_across};
  assert_true(refuse_each_allocation(&looked_at) > 0);
  assert_true(refuse_each_allocation(&left_alone) > 0);
}

static hg_status move_again(hg_grid *grid) {
  double centers[3 * CHAIN_COUNT] = {0};
  return hg_move(grid, CHAIN_COUNT, centers, NULL);
}

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(move_again); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(pairs_follow_the_particles),
                                     cmocka_unit_test(radii_change_when_given),
                                     cmocka_unit_test(rows_skip_removed_particles),
                                     cmocka_unit_test(empty_grid),
                                     cmocka_unit_test(wrong_count_is_refused),
                                     cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(bad_values_change_nothing),
                                     cmocka_unit_test(growth_beyond_the_box_is_refused),
                                     cmocka_unit_test(growth_beyond_the_user_cells_is_refused),
                                     cmocka_unit_test(too_far_outside_a_periodic_box),
                                     cmocka_unit_test(needs_no_memory),
                                     cmocka_unit_test(steps_need_no_memory_once_under_way),
                                     cmocka_unit_test(statistics_tell_searches_from_filters),
                                     cmocka_unit_test(no_skin_stores_nothing),
                                     cmocka_unit_test(a_skin_is_never_an_error),
                                     cmocka_unit_test(insert_remove_and_clear_make_candidates_stale),
                                     cmocka_unit_test(every_allocation_with_skin_fails_once),
                                     cmocka_unit_test(every_allocation_of_a_filter_fails_once),
                                     cmocka_unit_test(refused_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
