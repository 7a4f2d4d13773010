/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_set: exactly these particles, whatever was there; ids anew; all or nothing; candidates of a skin serve on. */
#include "tests/support/failing_alloc.h"
#include "tests/support/two_pairs.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static hg_grid *make_start(const hg_grid_def *def) {
  hg_grid *grid = make_empty(def);
  assert_ok(hg_set(grid, 4, kStart, kRadii));
  return grid;
}

TEST(any_count_in_every_step) {
  const size_t counts[] = {4, 2, 0, 4, 4, 1, 3};
  hg_grid *grid = make_empty(NULL);
  size_t k;
  for (k = 0; k < sizeof counts / sizeof counts[0]; ++k) {
    assert_ok(hg_set(grid, counts[k], kStart, kRadii));
    assert_int_equal(counts[k], stats_of(grid).particle_count);
    assert_pairs(grid, kStartPairs, counts[k] / 2);
  }
  hg_destroy(grid);
}

TEST(nothing_at_all) {
  hg_grid *grid = make_start(NULL);
  assert_ok(hg_set(grid, 0, NULL, NULL));
  assert_pairs(grid, NULL, 0);
  assert_ok(hg_set(grid, 0, NULL, NULL));
  assert_pairs(grid, NULL, 0);
  hg_destroy(grid);
}

/* Whatever gaps removal left, and from whichever base: ids count anew, also those of what is inserted later. */
TEST(ids_start_anew) {
  const int32_t gone = 2;
  const double near_0[3] = {0.5, 0, 0}, radius = 0.6;
  const hg_pair start[2] = {{1, 2}, {3, 4}}, with_new[4] = {{1, 2}, {1, 5}, {2, 5}, {3, 4}};
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  size_t count;
  def.index_base = 1;
  for (count = 3; count <= 4; ++count) { /* with gaps as many particles as there were, or one more */
    grid = make_start(&def);
    assert_ok(hg_remove(grid, 1, &gone));
    assert_ok(hg_set(grid, count, kStart, kRadii));
    assert_pairs(grid, start, count / 2);
    assert_ok(hg_set(grid, 4, kStart, kRadii));
    assert_ok(hg_insert(grid, 1, near_0, &radius));
    assert_pairs(grid, with_new, 4);
    hg_destroy(grid);
  }
}

TEST(null_is_refused) {
  hg_grid *grid = make_start(NULL);
  assert_status(HG_ERR_NULL, hg_set(NULL, 4, kMoved, kRadii));
  assert_status(HG_ERR_NULL, hg_set(grid, 4, NULL, kRadii));
  assert_status(HG_ERR_NULL, hg_set(grid, 4, kMoved, NULL));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

TEST(bad_values_change_nothing) {
  hg_grid *grid = make_start(NULL);
  size_t count;
  int row;
  for (count = 3; count <= 4; ++count) {
    for (row = 0; row < 3; ++row) {
      refuse_value(grid, hg_set, count, row, 0, not_a_number(), "nan");
      refuse_value(grid, hg_set, count, row, 2, -infinity(), "-inf");
      refuse_value(grid, hg_set, count, row, 3, -0.375, "-0.375");
      refuse_value(grid, hg_set, count, row, 3, infinity(), "inf");
    }
  }
  hg_destroy(grid);
}

/* In a box that is too short for two large particles the text names them by their new ids. */
TEST(a_short_box_is_refused) {
  const double grown[4] = {0.6, 0.6, 9, 9.5};
  const int32_t gone = 0;
  hg_grid_def def = periodic_axis(0, 20);
  hg_grid *grid = make_start(&def);
  assert_status(HG_ERR_ARGUMENT, hg_set(grid, 4, kMoved, grown));
  assert_pairs(grid, kStartPairs, 2);
  assert_ok(hg_remove(grid, 1, &gone));
  assert_status(HG_ERR_ARGUMENT, hg_set(grid, 4, kMoved, grown));
  assert_error_names("2");
  assert_error_names("3");
  assert_pairs(grid, kStartPairs + 1, 1);
  assert_ok(hg_set(grid, 1, kMoved, grown + 3)); /* alone it may fill the box */
  assert_pairs(grid, NULL, 0);
  hg_destroy(grid);
}

TEST(limits) {
  const double cell = 1.5, grown[4] = {0.6, 0.6, 0.6, 0.8};
  double centers[12];
  hg_grid_def def = user_levels(&cell, 1);
  hg_grid *grid = make_start(&def);
  assert_status(HG_ERR_ARGUMENT, hg_set(grid, 4, kMoved, grown));
  assert_status(HG_ERR_ARGUMENT, hg_set(grid, 3, kMoved, grown + 1));
  assert_status(HG_ERR_LIMIT, hg_set(grid, (size_t)INT32_MAX + 2, kMoved, kRadii));
  assert_status(HG_ERR_LIMIT, hg_set(grid, SIZE_MAX, kMoved, kRadii));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
  def = periodic_axis(0, 20);
  grid = make_start(&def);
  memcpy(centers, kMoved, sizeof centers);
  centers[6] = 1e13;
  assert_status(HG_ERR_LIMIT, hg_set(grid, 4, centers, kRadii));
  assert_status(HG_ERR_LIMIT, hg_set(grid, 3, centers, kRadii));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

TEST(bytes_at_any_address) {
  unsigned char bytes[1 + sizeof kMoved], radius_bytes[3 + sizeof kRadii];
  hg_grid *grid = make_start(NULL);
  memcpy(bytes + 1, kMoved, sizeof kMoved);
  memcpy(radius_bytes + 3, kRadii, sizeof kRadii);
  assert_ok(
      hg_set(grid, 4, (const double *)(const void *)(bytes + 1), (const double *)(const void *)(radius_bytes + 3)));
  assert_pairs(grid, kMovedPairs, 2);
  hg_destroy(grid);
}

static void step(hg_grid *grid, size_t count, const double *centers, const double *radii, int64_t searches,
                 int64_t filters) {
  assert_ok(hg_set(grid, count, centers, radii));
  assert_ok(search(grid));
  assert_int_equal(searches, stats_of(grid).search_count);
  assert_int_equal(filters, stats_of(grid).filter_count);
}

/* Equal count and radii: filtered as after hg_move; else searched. */
TEST(candidates_of_a_skin_stay_in_use) {
  const double grown[4] = {0.6, 0.75, 0.6, 0.6};
  const int32_t gone = 3;
  double centers[12];
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  def.skin = 0.2;
  grid = make_empty(&def);
  memcpy(centers, kStart, sizeof centers);
  step(grid, 4, centers, kRadii, 1, 0);
  centers[0] -= 0.09;
  step(grid, 4, centers, kRadii, 1, 1);
  step(grid, 4, kStart, kRadii, 1, 2);
  step(grid, 4, centers, grown, 2, 2);
  step(grid, 3, centers, grown, 3, 2);
  step(grid, 3, kStart, grown, 3, 3);
  step(grid, 4, kStart, kRadii, 4, 3);
  assert_ok(hg_remove(grid, 1, &gone));
  step(grid, 3, kStart, kRadii, 5, 3);
  step(grid, 3, centers, kRadii, 5, 4);
  assert_ok(hg_insert(grid, 1, kStart + 9, kRadii));
  step(grid, 4, kStart, kRadii, 6, 4);
  hg_destroy(grid);
}

/* Only growth takes memory. */
TEST(smaller_sets_need_no_memory) {
  hg_grid *grid;
  long long calls;
  failing_alloc_install();
  grid = make_start(NULL);
  assert_pairs(grid, kStartPairs, 2);
  calls = failing_alloc_books().calls;
  assert_ok(hg_set(grid, 3, kMoved, kRadii));
  assert_ok(hg_set(grid, 4, kMoved, kRadii));
  assert_int_equal(calls, failing_alloc_books().calls);
  assert_pairs(grid, kMovedPairs, 2);
  hg_destroy(grid);
  failing_alloc_remove();
}

static void prepare_pair(hg_grid **grid) { *grid = make_grid(NULL, 2, kStart, kRadii); }
static hg_status grow(hg_grid **grid) { return hg_set(*grid, 4, kMoved, kRadii); }
static void is_pair(hg_grid *grid) { assert_pairs(grid, kStartPairs, 1); }
static void is_swapped(hg_grid *grid) { assert_pairs(grid, kMovedPairs, 2); }

TEST(no_memory) {
  const alloc_scenario looked_at = {prepare_pair, grow, is_pair, is_swapped};
  const alloc_scenario left_alone = {prepare_pair, grow, NULL, is_swapped};
  assert_true(refuse_each_allocation(&looked_at) > 0);
  assert_true(refuse_each_allocation(&left_alone) > 0);
}

static hg_status set_again(hg_grid *grid) { return hg_set(grid, 4, kStart, kRadii); }
TEST(refused_inside_a_visitor) { assert_refused_in_visitor(set_again); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(any_count_in_every_step),
                                     cmocka_unit_test(nothing_at_all),
                                     cmocka_unit_test(ids_start_anew),
                                     cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(bad_values_change_nothing),
                                     cmocka_unit_test(a_short_box_is_refused),
                                     cmocka_unit_test(limits),
                                     cmocka_unit_test(bytes_at_any_address),
                                     cmocka_unit_test(candidates_of_a_skin_stay_in_use),
                                     cmocka_unit_test(smaller_sets_need_no_memory),
                                     cmocka_unit_test(no_memory),
                                     cmocka_unit_test(refused_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
