/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_insert_arrays: as hg_insert, from arrays of any stride and type. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

/* Structs of a caller: floats and doubles side by side. */
typedef struct grain {
  float radius;
  double place[3];
} grain;

static grain grains[CHAIN_COUNT];

static void fill(hg_array *centers, hg_array *radius) {
  int i, axis;
  for (i = 0; i < CHAIN_COUNT; ++i) {
    grains[i].radius = 0.6f;
    grains[i].place[0] = i;
  }
  for (axis = 0; axis < 3; ++axis) {
    centers[axis].data = &grains[0].place[axis];
    centers[axis].stride = sizeof(grain);
    centers[axis].type = HG_REAL64;
    centers[axis].reserved = 0;
  }
  radius->data = &grains[0].radius;
  radius->stride = sizeof(grain);
  radius->type = HG_REAL32;
  radius->reserved = 0;
}

static hg_status insert_rest(hg_grid **grid) {
  hg_array centers[3], radius;
  int axis;
  fill(centers, &radius);
  for (axis = 0; axis < 3; ++axis) centers[axis].data = &grains[4].place[axis];
  return hg_insert_arrays(*grid, CHAIN_COUNT - 4, centers, &radius);
}

static void prepare_beginning(hg_grid **grid) {
  hg_array centers[3], radius;
  fill(centers, &radius);
  *grid = make_empty(NULL);
  assert_ok(hg_insert_arrays(*grid, 4, centers, &radius));
}

static void is_beginning(hg_grid *grid) {
  const hg_pair pairs[3] = {{0, 1}, {1, 2}, {2, 3}};
  assert_pairs(grid, pairs, 3);
}

static void is_chain(hg_grid *grid) { assert_chain(grid, 0); }

TEST(ids_go_on_counting) {
  hg_grid *grid;
  prepare_beginning(&grid);
  is_beginning(grid);
  assert_ok(insert_rest(&grid));
  assert_chain(grid, 0);
  hg_destroy(grid);
}

TEST(two_dimensions) {
  hg_array centers[3], radius;
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  def.dimension = 2;
  fill(centers, &radius);
  centers[2].data = NULL; /* not looked at */
  grid = make_empty(&def);
  assert_ok(hg_insert_arrays(grid, CHAIN_COUNT, centers, &radius));
  assert_chain(grid, 0);
  hg_destroy(grid);
}

TEST(refusals_change_nothing) {
  hg_array centers[3], radius;
  hg_grid *grid;
  prepare_beginning(&grid);
  fill(centers, &radius);
  assert_ok(hg_insert_arrays(grid, 0, NULL, NULL));
  assert_status(HG_ERR_NULL, hg_insert_arrays(NULL, 1, centers, &radius));
  assert_status(HG_ERR_NULL, hg_insert_arrays(grid, 1, NULL, &radius));
  assert_status(HG_ERR_NULL, hg_insert_arrays(grid, 1, centers, NULL));
  radius.type = 7;
  assert_status(HG_ERR_ARGUMENT, hg_insert_arrays(grid, 1, centers, &radius));
  assert_error_names("radius.type = 7");
  fill(centers, &radius);
  assert_status(HG_ERR_LIMIT, hg_insert_arrays(grid, (size_t)INT32_MAX, centers, &radius));
  grains[3].place[1] = not_a_number();
  assert_status(HG_ERR_ARGUMENT, hg_insert_arrays(grid, 4, centers, &radius));
  assert_error_names("centers[3][1]");
  grains[3].place[1] = 0;
  is_beginning(grid);
  assert_ok(insert_rest(&grid));
  assert_chain(grid, 0);
  hg_destroy(grid);
}

TEST(no_memory) {
  const alloc_scenario looked_at = {prepare_beginning, insert_rest, is_beginning, is_chain};
  const alloc_scenario left_alone = {prepare_beginning, insert_rest, NULL, is_chain};
  assert_true(refuse_each_allocation(&looked_at) > 0);
  assert_true(refuse_each_allocation(&left_alone) > 0);
}

static hg_status insert_again(hg_grid *grid) { return insert_rest(&grid); }
TEST(refused_inside_a_visitor) { assert_refused_in_visitor(insert_again); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(ids_go_on_counting), cmocka_unit_test(two_dimensions),
                                     cmocka_unit_test(refusals_change_nothing), cmocka_unit_test(no_memory),
                                     cmocka_unit_test(refused_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
