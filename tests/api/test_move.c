/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_move: new centres and radii in id order; all or nothing; no memory needed. */
#include "failing_alloc.h"
#include "fixture.h"

#include <string.h>

/* Two pairs of spheres: (0, 1) and (2, 3) overlap. */
static const double kStart[12] = {0, 0, 0, 1, 0, 0, 10, 0, 0, 11, 0, 0};
static const double kRadii[4] = {0.6, 0.6, 0.6, 0.6};
static const hg_pair kStartPairs[2] = {{0, 1}, {2, 3}};
/* Swapped partners: (0, 2) and (1, 3) overlap. */
static const double kMoved[12] = {0, 0, 0, 10, 0, 0, 1, 0, 0, 11, 0, 0};
static const hg_pair kMovedPairs[2] = {{0, 2}, {1, 3}};

static void pairs_follow_the_particles(void **state) {
  hg_grid *grid = make_grid(NULL, 4, kStart, kRadii);
  (void)state;
  assert_pairs(grid, kStartPairs, 2);
  assert_ok(hg_move(grid, 4, kMoved, NULL));
  assert_pairs(grid, kMovedPairs, 2);
  assert_ok(hg_move(grid, 4, kStart, kRadii));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

static void radii_change_when_given(void **state) {
  const double small[4] = {0.6, 0.6, 0.1, 0.1}, large[4] = {0.6, 0.6, 0.6, 100};
  const hg_pair all_with_3[4] = {{0, 1}, {0, 3}, {1, 3}, {2, 3}};
  hg_grid *grid = make_grid(NULL, 4, kStart, kRadii);
  (void)state;
  assert_ok(hg_move(grid, 4, kStart, small));
  assert_pairs(grid, kStartPairs, 1);
  assert_ok(hg_move(grid, 4, kStart, NULL));
  assert_pairs(grid, kStartPairs, 1);
  assert_ok(hg_move(grid, 4, kStart, large));
  assert_pairs(grid, all_with_3, 4);
  hg_destroy(grid);
}

/* Rows follow the live particles in ascending id. */
static void rows_skip_removed_particles(void **state) {
  const int32_t gone = 1;
  const double centers[9] = {0, 0, 0, 5, 0, 0, 1, 0, 0};
  const hg_pair expected[1] = {{0, 3}};
  hg_grid *grid = make_grid(NULL, 4, kStart, kRadii);
  (void)state;
  assert_ok(hg_remove(grid, 1, &gone));
  assert_status(HG_ERR_ARGUMENT, hg_move(grid, 4, kMoved, NULL));
  assert_ok(hg_move(grid, 3, centers, NULL));
  assert_pairs(grid, expected, 1);
  hg_destroy(grid);
}

static void empty_grid(void **state) {
  hg_grid *grid = make_empty(NULL);
  (void)state;
  assert_ok(hg_move(grid, 0, NULL, NULL));
  assert_ok(hg_move(grid, 0, kStart, kRadii));
  assert_status(HG_ERR_ARGUMENT, hg_move(grid, 1, kStart, NULL));
  assert_pairs(grid, NULL, 0);
  hg_destroy(grid);
}

static void wrong_count_is_refused(void **state) {
  hg_grid *grid = make_grid(NULL, 4, kStart, kRadii);
  (void)state;
  assert_status(HG_ERR_ARGUMENT, hg_move(grid, 3, kMoved, NULL));
  assert_error_names("3");
  assert_error_names("4");
  assert_status(HG_ERR_ARGUMENT, hg_move(grid, 0, NULL, NULL));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

static void null_is_refused(void **state) {
  hg_grid *grid = make_grid(NULL, 4, kStart, kRadii);
  (void)state;
  assert_status(HG_ERR_NULL, hg_move(NULL, 4, kMoved, NULL));
  assert_status(HG_ERR_NULL, hg_move(grid, 4, NULL, kRadii));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

static void refuse(hg_grid *grid, int row, int axis, double value, const char *text) {
  double centers[12], radii[4];
  char row_text[2] = {0};
  memcpy(centers, kMoved, sizeof centers);
  memcpy(radii, kRadii, sizeof radii);
  if (axis == 3) {
    radii[row] = value;
  } else {
    centers[3 * row + axis] = value;
  }
  assert_status(HG_ERR_ARGUMENT, hg_move(grid, 4, centers, radii));
  row_text[0] = (char)('0' + row);
  assert_error_names(row_text);
  assert_error_names(text);
  assert_pairs(grid, kStartPairs, 2);
}

static void bad_values_change_nothing(void **state) {
  hg_grid *grid = make_grid(NULL, 4, kStart, kRadii);
  int row;
  (void)state;
  for (row = 0; row < 4; ++row) {
    refuse(grid, row, 0, not_a_number(), "nan");
    refuse(grid, row, 2, -infinity(), "-inf");
    refuse(grid, row, 3, -0.375, "-0.375");
    refuse(grid, row, 3, not_a_number(), "nan");
    refuse(grid, row, 3, infinity(), "inf");
  }
  hg_destroy(grid);
}

static void growth_beyond_the_box_is_refused(void **state) {
  const double grown[4] = {0.6, 0.6, 0.6, 8};
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  (void)state;
  def.periodic[0] = 1;
  def.box_max[0] = 20;
  grid = make_grid(&def, 4, kStart, kRadii);
  assert_status(HG_ERR_ARGUMENT, hg_move(grid, 4, kMoved, grown));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

static void growth_beyond_the_user_cells_is_refused(void **state) {
  const double cell = 1.5, grown[4] = {0.6, 0.6, 0.6, 0.8};
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  (void)state;
  def.level_rule = HG_LEVELS_USER;
  def.level_count = 1;
  def.cell_sizes = &cell;
  grid = make_grid(&def, 4, kStart, kRadii);
  assert_status(HG_ERR_ARGUMENT, hg_move(grid, 4, kMoved, grown));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

static void too_far_outside_a_periodic_box(void **state) {
  double centers[12];
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  (void)state;
  def.periodic[0] = 1;
  def.box_max[0] = 20;
  grid = make_grid(&def, 4, kStart, kRadii);
  memcpy(centers, kMoved, sizeof centers);
  centers[6] = 1e13;
  assert_status(HG_ERR_LIMIT, hg_move(grid, 4, centers, NULL));
  assert_pairs(grid, kStartPairs, 2);
  hg_destroy(grid);
}

static void needs_no_memory(void **state) {
  hg_grid *grid;
  long long calls;
  (void)state;
  failing_alloc_install();
  grid = make_grid(NULL, 4, kStart, kRadii);
  assert_pairs(grid, kStartPairs, 2);
  calls = failing_alloc_books().calls;
  assert_ok(hg_move(grid, 4, kMoved, kRadii));
  assert_int_equal(calls, failing_alloc_books().calls);
  assert_pairs(grid, kMovedPairs, 2);
  hg_destroy(grid);
  failing_alloc_remove();
}

static hg_status move_again(hg_grid *grid) {
  double centers[3 * CHAIN_COUNT] = {0};
  return hg_move(grid, CHAIN_COUNT, centers, NULL);
}

static void refused_inside_a_visitor(void **state) {
  (void)state;
  assert_refused_in_visitor(move_again);
}

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
                                     cmocka_unit_test(refused_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
