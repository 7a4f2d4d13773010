/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_move_arrays: as hg_move, from arrays of any stride and type. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

/* A column of floats, and a number that all particles share. */
static const float kX[CHAIN_COUNT] = {0, 1, 2, 3, 4, 5, 6, 7, 8}, kApart[CHAIN_COUNT] = {0, 2, 4, 6, 8, 10, 12, 14, 16};
static const double kZero = 0, kRadius = 0.6, kLarge = 1.01;

static hg_array array_of(const void *data, int64_t stride, int32_t type) {
  hg_array array;
  array.data = data;
  array.stride = stride;
  array.type = type;
  array.reserved = 0;
  return array;
}

static hg_status move(hg_grid *grid, size_t count, const float *x, const double *radius) {
  const hg_array same = array_of(radius, 0, HG_REAL64);
  hg_array centers[3];
  centers[0] = array_of(x, sizeof *x, HG_REAL32);
  centers[1] = centers[2] = array_of(&kZero, 0, HG_REAL64);
  return hg_move_arrays(grid, count, centers, radius != NULL ? &same : NULL);
}

TEST(centres_and_radii) {
  hg_grid *grid = make_chain(NULL);
  assert_ok(move(grid, CHAIN_COUNT, kApart, NULL));
  assert_pairs(grid, NULL, 0);
  assert_ok(move(grid, CHAIN_COUNT, kApart, &kLarge));
  assert_chain(grid, 0);
  assert_ok(move(grid, CHAIN_COUNT, kX, &kRadius));
  assert_chain(grid, 0);
  assert_ok(move(grid, CHAIN_COUNT, kX, NULL));
  assert_chain(grid, 0);
  hg_destroy(grid);
}

TEST(candidates_of_a_skin_stay_in_use) {
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  def.skin = 0.2;
  grid = make_chain(&def);
  assert_chain(grid, 0);
  assert_ok(move(grid, CHAIN_COUNT, kX, &kRadius));
  assert_chain(grid, 0);
  assert_int_equal(1, stats_of(grid).search_count);
  assert_int_equal(1, stats_of(grid).filter_count);
  hg_destroy(grid);
}

TEST(refusals_change_nothing) {
  const float bad[CHAIN_COUNT] = {0, 0, -1};
  const hg_array radius = array_of(bad, sizeof(float), HG_REAL32);
  hg_array centers[3];
  hg_grid *grid = make_chain(NULL), *empty = make_empty(NULL);
  centers[0] = centers[1] = centers[2] = array_of(kX, sizeof(float), HG_REAL32);
  assert_ok(hg_move_arrays(empty, 0, NULL, NULL));
  assert_status(HG_ERR_ARGUMENT, move(empty, 1, kApart, NULL));
  assert_status(HG_ERR_ARGUMENT, move(grid, CHAIN_COUNT - 1, kApart, NULL));
  assert_error_names("8");
  assert_error_names("9");
  assert_status(HG_ERR_ARGUMENT, hg_move_arrays(grid, SIZE_MAX, centers, &radius)); /* before anything is read */
  assert_status(HG_ERR_NULL, hg_move_arrays(NULL, CHAIN_COUNT, centers, NULL));
  assert_status(HG_ERR_NULL, hg_move_arrays(grid, CHAIN_COUNT, NULL, NULL));
  assert_status(HG_ERR_ARGUMENT, hg_move_arrays(grid, CHAIN_COUNT, centers, &radius));
  assert_error_names("radii[2] = -1");
  centers[1].reserved = 1;
  assert_status(HG_ERR_ARGUMENT, hg_move_arrays(grid, CHAIN_COUNT, centers, NULL));
  assert_error_names("centers[1].reserved = 1");
  assert_chain(grid, 0);
  hg_destroy(grid);
  hg_destroy(empty);
}

static hg_status move_again(hg_grid *grid) { return move(grid, CHAIN_COUNT, kX, &kRadius); }
TEST(no_memory) { assert_true(refuse_each_allocation_on_chain(move_again) > 0); }
TEST(refused_inside_a_visitor) { assert_refused_in_visitor(move_again); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(centres_and_radii),
                                     cmocka_unit_test(candidates_of_a_skin_stay_in_use),
                                     cmocka_unit_test(refusals_change_nothing), cmocka_unit_test(no_memory),
                                     cmocka_unit_test(refused_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
