/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_query_triangles: rows of particles that triangles meet. What one row holds is tested by property/test_shapes. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

/* On the chain: across 3 and 4; far away; a segment near 4 to 7; a point beside 0. */
enum { TRIANGLES = 4 };
static double corners[9 * TRIANGLES] = {3.5, -5, -5, 3.5, 5, -5, 3.5,   0, 5, 50, 0,   0, 51, 0,   0, 50, 1,   0,
                                        4.5, 0,  0,  6,   0, 0,  6.875, 0, 0, 0,  0.5, 0, 0,  0.5, 0, 0,  0.5, 0};
static const int64_t kOffsets[TRIANGLES + 1] = {0, 2, 2, 6, 7};
static const int32_t kIds[7] = {3, 4, 4, 5, 6, 7, 0};

static hg_status query(hg_grid *grid) {
  const int64_t *offsets = NULL;
  const int32_t *ids = NULL;
  const hg_status status = hg_query_triangles(grid, TRIANGLES, corners, &offsets, &ids);
  if (status == HG_OK) {
    assert_memory_equal(offsets, kOffsets, sizeof kOffsets);
    assert_memory_equal(ids, kIds, sizeof kIds);
  }
  return status;
}

TEST(rows_in_the_order_of_the_triangles) {
  hg_grid *grid = make_chain(NULL);
  assert_ok(query(grid));
  hg_destroy(grid);
}

TEST(no_triangles) {
  const int64_t *offsets = NULL;
  const int32_t *ids = NULL;
  hg_grid *grid = make_empty(NULL);
  assert_ok(hg_query_triangles(grid, 0, NULL, &offsets, &ids));
  assert_int_equal(0, offsets[0]);
  assert_ok(hg_query_triangles(grid, TRIANGLES, corners, &offsets, &ids));
  assert_int_equal(0, offsets[TRIANGLES]);
  hg_destroy(grid);
}

/* A wall at y = 2 through all of a periodic box, met around its edge by particles beyond the face. */
TEST(any_image_counts_once) {
  const double centers[9] = {1, 2.5, 1, 9.75, 2.5, 1, 5, 4, 1}, radii[3] = {0.75, 0.75, 0.75};
  const double wall[9] = {0, 2, 0, 20, 2, 0, 0, 2, 20}, point[9] = {-0.125, 2.5, 1, -0.125, 2.5, 1, -0.125, 2.5, 1};
  const hg_grid_def def = periodic_axis(0, 10);
  hg_grid *grid = make_grid(&def, 3, centers, radii);
  const int64_t *offsets;
  const int32_t *ids;
  assert_ok(hg_query_triangles(grid, 1, wall, &offsets, &ids));
  assert_int_equal(2, offsets[1]);
  assert_int_equal(1, ids[1]);
  assert_ok(hg_query_triangles(grid, 1, point, &offsets, &ids));
  assert_int_equal(1, offsets[1]);
  assert_int_equal(1, ids[0]);
  hg_destroy(grid);
}

static void refuse(hg_grid *grid, hg_status status, int number, double bad, const char *text) {
  const double good = corners[number];
  const int64_t *offsets = kOffsets;
  const int32_t *ids = kIds;
  corners[number] = bad;
  assert_status(status, hg_query_triangles(grid, TRIANGLES, corners, &offsets, &ids));
  assert_error_names(text);
  assert_true(offsets == kOffsets && ids == kIds);
  corners[number] = good;
}

TEST(bad_arguments) {
  hg_grid_def def = periodic_axis(1, 1);
  hg_grid *grid = make_chain(NULL), *periodic = make_empty(&def), *cell;
  const int64_t *offsets;
  const int32_t *ids;
  int axis;
  assert_status(HG_ERR_NULL, hg_query_triangles(NULL, TRIANGLES, corners, &offsets, &ids));
  assert_status(HG_ERR_NULL, hg_query_triangles(grid, TRIANGLES, NULL, &offsets, &ids));
  assert_status(HG_ERR_NULL, hg_query_triangles(grid, TRIANGLES, corners, NULL, &ids));
  assert_status(HG_ERR_NULL, hg_query_triangles(grid, TRIANGLES, corners, &offsets, NULL));
  refuse(grid, HG_ERR_ARGUMENT, 16, not_a_number(), "corners[1][2][1] = nan");
  refuse(grid, HG_ERR_ARGUMENT, 27, infinity(), "corners[3][0][0] = inf");
  refuse(periodic, HG_ERR_ARGUMENT, 10, 4294967296.0, "corners[1][0][1]");
  for (axis = 0; axis < 3; ++axis) {
    def.periodic[axis] = 1;
    def.box_max[axis] = 0.0078125;
  }
  cell = make_empty(&def);
  refuse(cell, HG_ERR_LIMIT, 0, 4096, "corners[0]");
  assert_ok(query(grid));
  hg_destroy(grid);
  hg_destroy(periodic);
  hg_destroy(cell);
}

TEST(refused_in_a_plane_and_a_tilted_cell) {
  const int64_t *offsets;
  const int32_t *ids;
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  int axis;
  for (axis = 0; axis < 3; ++axis) {
    def.periodic[axis] = 1;
    def.box_max[axis] = 10;
  }
  def.tilt[0] = 1;
  grid = make_empty(&def);
  assert_status(HG_ERR_STATE, hg_query_triangles(grid, TRIANGLES, corners, &offsets, &ids));
  assert_error_names("tilted");
  hg_destroy(grid);
  def.tilt[0] = 0;
  def.dimension = 2;
  grid = make_empty(&def);
  assert_status(HG_ERR_STATE, hg_query_triangles(grid, TRIANGLES, corners, &offsets, &ids));
  assert_error_names("three dimensions");
  hg_destroy(grid);
}

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(query); }

TEST(no_memory) { assert_true(refuse_each_allocation_on_chain(query) > 0); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(rows_in_the_order_of_the_triangles),
                                     cmocka_unit_test(no_triangles),
                                     cmocka_unit_test(any_image_counts_once),
                                     cmocka_unit_test(bad_arguments),
                                     cmocka_unit_test(refused_in_a_plane_and_a_tilted_cell),
                                     cmocka_unit_test(refused_inside_a_visitor),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
