/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_set_arrays: numbers wherever the caller keeps them, by any stride, at any address, in either precision. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

#include <stdint.h>
#include <string.h>

static hg_array array_of(const void *data, int64_t stride, int32_t type) {
  hg_array array;
  array.data = data;
  array.stride = stride;
  array.type = type;
  array.reserved = 0;
  return array;
}

/* The chain as columns of floats and doubles. */
static const double kX[CHAIN_COUNT] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
static const float kY[CHAIN_COUNT] = {0};
static const double kRadius = 0.6;

static void fill_chain(hg_array *centers, hg_array *radius) {
  centers[0] = array_of(kX, sizeof(double), HG_REAL64);
  centers[1] = array_of(kY, sizeof(float), HG_REAL32);
  centers[2] = array_of(kY, 0, HG_REAL32);
  *radius = array_of(&kRadius, 0, HG_REAL64);
}

static hg_status set_chain(hg_grid *grid) {
  hg_array centers[3], radius;
  fill_chain(centers, &radius);
  return hg_set_arrays(grid, CHAIN_COUNT, centers, &radius);
}

TEST(columns_of_mixed_types) {
  hg_grid *grid = make_empty(NULL);
  assert_ok(set_chain(grid));
  assert_chain(grid, 0);
  hg_destroy(grid);
}

/* Structs without padding, so that the numbers lie at odd addresses, from the last to the first. */
TEST(members_of_structs_backwards) {
  enum { SIZE = 1 + sizeof(double) + sizeof(float) };
  unsigned char bytes[CHAIN_COUNT * SIZE];
  const unsigned char *last = bytes + (CHAIN_COUNT - 1) * SIZE;
  hg_array centers[3], radius;
  hg_grid *grid = make_empty(NULL);
  int i;
  for (i = 0; i < CHAIN_COUNT; ++i) {
    const float r = 0.6f;
    memcpy(bytes + i * SIZE + 1, kX + (CHAIN_COUNT - 1 - i), sizeof(double));
    memcpy(bytes + i * SIZE + 1 + sizeof(double), &r, sizeof r);
  }
  fill_chain(centers, &radius);
  centers[0] = array_of(last + 1, -SIZE, HG_REAL64);
  radius = array_of(last + 1 + sizeof(double), -SIZE, HG_REAL32);
  assert_ok(hg_set_arrays(grid, CHAIN_COUNT, centers, &radius));
  assert_chain(grid, 0);
  hg_destroy(grid);
}

/* Floats that touch are no pair; beside a double that is larger by less than a float can tell they are one. */
TEST(floats_are_widened_exactly) {
  const float x[2] = {0, 0.1f}, r[2] = {0.05f, 0.05f};
  const double larger[2] = {(double)0.05f, (double)0.05f * (1 + 1e-15)};
  const hg_pair pair = {0, 1};
  hg_array centers[2], radius;
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  def.dimension = 2;
  grid = make_empty(&def);
  centers[0] = array_of(x, sizeof(float), HG_REAL32);
  centers[1] = array_of(kY, sizeof(float), HG_REAL32);
  radius = array_of(r, sizeof(float), HG_REAL32);
  assert_ok(hg_set_arrays(grid, 2, centers, &radius));
  assert_pairs(grid, NULL, 0);
  radius = array_of(larger, sizeof(double), HG_REAL64);
  assert_ok(hg_set_arrays(grid, 2, centers, &radius));
  assert_pairs(grid, &pair, 1);
  hg_destroy(grid);
}

TEST(nothing_at_all) {
  hg_array centers[3], radius;
  hg_grid *grid = make_chain(NULL);
  assert_ok(hg_set_arrays(grid, 0, NULL, NULL));
  assert_pairs(grid, NULL, 0);
  fill_chain(centers, &radius);
  centers[1].data = NULL;
  assert_ok(hg_set_arrays(grid, 0, centers, &radius));
  hg_destroy(grid);
}

TEST(null_is_refused) {
  hg_array centers[3], radius;
  hg_grid *grid = make_chain(NULL);
  fill_chain(centers, &radius);
  assert_status(HG_ERR_NULL, hg_set_arrays(NULL, 3, centers, &radius));
  assert_status(HG_ERR_NULL, hg_set_arrays(grid, 3, NULL, &radius));
  assert_error_names("centers");
  assert_status(HG_ERR_NULL, hg_set_arrays(grid, 3, centers, NULL));
  assert_error_names("radius");
  radius.data = NULL;
  assert_status(HG_ERR_NULL, hg_set_arrays(grid, 3, centers, &radius));
  assert_error_names("radius");
  fill_chain(centers, &radius);
  centers[2].data = NULL;
  assert_status(HG_ERR_NULL, hg_set_arrays(grid, 3, centers, &radius));
  assert_error_names("centers[2]");
  assert_chain(grid, 0);
  hg_destroy(grid);
}

TEST(types_that_are_none) {
  hg_array centers[3], radius;
  hg_grid *grid = make_chain(NULL);
  fill_chain(centers, &radius);
  centers[1].type = 2;
  assert_status(HG_ERR_ARGUMENT, hg_set_arrays(grid, 3, centers, &radius));
  assert_error_names("centers[1].type = 2");
  fill_chain(centers, &radius);
  radius.type = -1;
  assert_status(HG_ERR_ARGUMENT, hg_set_arrays(grid, 3, centers, &radius));
  assert_error_names("radius.type = -1");
  fill_chain(centers, &radius);
  radius.reserved = 5;
  assert_status(HG_ERR_ARGUMENT, hg_set_arrays(grid, 3, centers, &radius));
  assert_error_names("radius.reserved = 5");
  assert_chain(grid, 0);
  hg_destroy(grid);
}

TEST(bad_values_change_nothing) {
  const float bad_y[3] = {0, 0, -2};
  hg_array centers[3], radius;
  hg_grid *grid = make_chain(NULL);
  fill_chain(centers, &radius);
  radius = array_of(bad_y, sizeof(float), HG_REAL32);
  assert_status(HG_ERR_ARGUMENT, hg_set_arrays(grid, 3, centers, &radius));
  assert_error_names("radii[2] = -2");
  assert_status(HG_ERR_LIMIT, hg_set_arrays(grid, (size_t)INT32_MAX + 2, centers, &radius));
  assert_status(HG_ERR_LIMIT, hg_set_arrays(grid, SIZE_MAX, centers, &radius));
  assert_chain(grid, 0);
  hg_destroy(grid);
}

TEST(steps_need_no_memory_once_under_way) {
  hg_grid *grid;
  long long calls;
  failing_alloc_install();
  grid = make_empty(NULL);
  assert_ok(set_chain(grid));
  assert_chain(grid, 0);
  calls = failing_alloc_books().calls;
  assert_ok(set_chain(grid));
  assert_chain(grid, 0);
  assert_int_equal(calls, failing_alloc_books().calls);
  hg_destroy(grid);
  failing_alloc_remove();
}

TEST(no_memory) { assert_true(refuse_each_allocation_on_chain(set_chain) > 0); }

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(set_chain); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(columns_of_mixed_types),
                                     cmocka_unit_test(members_of_structs_backwards),
                                     cmocka_unit_test(floats_are_widened_exactly),
                                     cmocka_unit_test(nothing_at_all),
                                     cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(types_that_are_none),
                                     cmocka_unit_test(bad_values_change_nothing),
                                     cmocka_unit_test(steps_need_no_memory_once_under_way),
                                     cmocka_unit_test(no_memory),
                                     cmocka_unit_test(refused_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
