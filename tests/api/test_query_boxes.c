/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_query_boxes: rows of particles that boxes meet. What one row holds is tested by property/test_shapes. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

#include <string.h>

/* Boxes on the chain: around 3 and 4, which 2 and 5 do not touch; nowhere; all of space beyond 7. */
enum { BOXES = 3 };
static double low[3 * BOXES] = {2.625, -1, -1, 100, 0, 0, 7, 0, 0}, high[3 * BOXES] = {4.375, 1, 1, 101, 1, 1, 0, 0, 0};
static const int64_t kOffsets[BOXES + 1] = {0, 2, 2, 4};
static const int32_t kIds[4] = {3, 4, 7, 8};

static hg_status query(hg_grid *grid) {
  const int64_t *offsets = NULL;
  const int32_t *ids = NULL;
  hg_status status;
  high[6] = infinity();
  status = hg_query_boxes(grid, BOXES, low, high, &offsets, &ids);
  if (status == HG_OK) {
    assert_memory_equal(offsets, kOffsets, sizeof kOffsets);
    assert_memory_equal(ids, kIds, sizeof kIds);
  }
  return status;
}

TEST(rows_in_the_order_of_the_boxes) {
  hg_grid *grid = make_chain(NULL);
  assert_ok(query(grid));
  hg_destroy(grid);
}

TEST(no_boxes) {
  const int64_t *offsets = NULL;
  const int32_t *ids = NULL;
  hg_grid *grid = make_empty(NULL);
  assert_ok(hg_query_boxes(grid, 0, NULL, NULL, &offsets, &ids));
  assert_int_equal(0, offsets[0]);
  assert_ok(hg_query_boxes(grid, BOXES, low, high, &offsets, &ids));
  assert_int_equal(0, offsets[BOXES]);
  hg_destroy(grid);
}

/* 3D: the corner (3, 4) of a square is 5 away. */
TEST(touching_margin_and_points) {
  const double centers[6] = {0, 0, 0, 10, 0, 0}, radii[2] = {4.5, 0};
  const double corner[6] = {3, 4, 0, 10, 0, 0}, opposite[6] = {8, 8, 0, 10, 0, 0};
  hg_grid_def def = hg_default_grid_def();
  int k;
  for (k = 0; k < 4; ++k) {
    const int64_t *offsets;
    const int32_t *ids;
    hg_grid *grid;
    def.touching = k % 2;
    def.interaction = k / 2 == 0 ? HG_CONTACT : HG_MAX_RANGE;
    def.margin = 0.5;
    grid = make_grid(&def, 2, centers, radii);
    assert_ok(hg_query_boxes(grid, 2, corner, opposite, &offsets, &ids));
    assert_int_equal(def.touching, offsets[1]);
    assert_int_equal(1, offsets[2] - offsets[1]);
    assert_int_equal(1, ids[offsets[1]]);
    hg_destroy(grid);
  }
}

TEST(any_image_counts_once) {
  const double centers[3] = {0.25, 0, 0}, radii[1] = {0.5};
  const double from[9] = {9.8, 0, 0, -100, 0, 0, 9, 0, 0}, to[9] = {9.9, 1, 1, 100, 1, 1, 9.75, 1, 1};
  const hg_grid_def def = periodic_axis(0, 10);
  const int64_t wanted[4] = {0, 1, 2, 2};
  hg_grid *grid = make_grid(&def, 1, centers, radii);
  const int64_t *offsets;
  const int32_t *ids;
  assert_ok(hg_query_boxes(grid, 3, from, to, &offsets, &ids));
  assert_memory_equal(offsets, wanted, sizeof wanted);
  hg_destroy(grid);
}

static void refuse(hg_grid *grid, double *value, double bad, const char *name, const char *text) {
  const double good = *value;
  const int64_t *offsets = kOffsets;
  const int32_t *ids = kIds;
  *value = bad;
  assert_status(HG_ERR_ARGUMENT, hg_query_boxes(grid, BOXES, low, high, &offsets, &ids));
  assert_error_names(name);
  assert_error_names(text);
  assert_true(offsets == kOffsets && ids == kIds);
  *value = good;
}

TEST(bad_arguments) {
  const hg_grid_def def = periodic_axis(1, 1);
  hg_grid *grid = make_chain(NULL), *periodic = make_empty(&def);
  const int64_t *offsets;
  const int32_t *ids;
  assert_status(HG_ERR_NULL, hg_query_boxes(NULL, BOXES, low, high, &offsets, &ids));
  assert_status(HG_ERR_NULL, hg_query_boxes(grid, BOXES, NULL, high, &offsets, &ids));
  assert_status(HG_ERR_NULL, hg_query_boxes(grid, BOXES, low, NULL, &offsets, &ids));
  assert_status(HG_ERR_NULL, hg_query_boxes(grid, BOXES, low, high, NULL, &ids));
  assert_status(HG_ERR_NULL, hg_query_boxes(grid, BOXES, low, high, &offsets, NULL));
  refuse(grid, &low[4], not_a_number(), "low[1][1]", "nan");
  refuse(grid, &high[8], not_a_number(), "high[2][2]", "nan");
  refuse(grid, &low[3], 101.5, "low[1][0]", "101.5");
  refuse(grid, &high[2], -1.25, "high[0][2]", "-1.25");
  high[4] += 4294967296.0;
  refuse(periodic, &low[4], 4294967296.0, "low[1][1]", "2^20 box lengths");
  high[4] -= 4294967296.0;
  assert_ok(query(grid));
  hg_destroy(grid);
  hg_destroy(periodic);
}

TEST(refused_in_a_tilted_cell) {
  const int64_t *offsets;
  const int32_t *ids;
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  int axis;
  for (axis = 0; axis < 3; ++axis) {
    def.periodic[axis] = 1;
    def.box_max[axis] = 10;
  }
  def.tilt[1] = 1;
  grid = make_empty(&def);
  assert_status(HG_ERR_STATE, hg_query_boxes(grid, BOXES, low, high, &offsets, &ids));
  assert_error_names("tilted");
  hg_destroy(grid);
}

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(query); }

TEST(no_memory) { assert_true(refuse_each_allocation_on_chain(query) > 0); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(rows_in_the_order_of_the_boxes),
                                     cmocka_unit_test(no_boxes),
                                     cmocka_unit_test(touching_margin_and_points),
                                     cmocka_unit_test(any_image_counts_once),
                                     cmocka_unit_test(bad_arguments),
                                     cmocka_unit_test(refused_in_a_tilted_cell),
                                     cmocka_unit_test(refused_inside_a_visitor),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
