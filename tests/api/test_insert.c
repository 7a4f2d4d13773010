/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_insert: ids, bad values by index, limits; all or nothing. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

#include <string.h>

TEST(ids_go_on_counting) {
  const double near_ends[6] = {-1, 0, 0, CHAIN_COUNT, 0, 0};
  const double radii[2] = {0.6, 0.6};
  int32_t base;
  for (base = 0; base <= 1; ++base) {
    hg_grid_def def = hg_default_grid_def();
    hg_pair expected[CHAIN_COUNT + 1];
    hg_grid *grid;
    int32_t i;
    def.index_base = base;
    grid = make_chain(&def);
    assert_chain(grid, base);
    assert_ok(hg_insert(grid, 2, near_ends, radii));
    expected[0].a = base;
    expected[0].b = base + 1;
    expected[1].a = base;
    expected[1].b = base + CHAIN_COUNT;
    for (i = 1; i < CHAIN_COUNT; ++i) {
      expected[i + 1].a = base + i;
      expected[i + 1].b = base + i + 1;
    }
    expected[CHAIN_COUNT].b = base + CHAIN_COUNT + 1;
    assert_pairs(grid, expected, CHAIN_COUNT + 1);
    hg_destroy(grid);
  }
}

TEST(small_counts) {
  const double centers[6] = {0, 0, 0, 1.5, 0, 0};
  const double radii[2] = {1, 1};
  const hg_pair only = {0, 1};
  hg_grid *grid = make_empty(NULL);
  assert_ok(hg_insert(grid, 0, NULL, NULL));
  assert_ok(hg_insert(grid, 0, centers, radii));
  assert_pairs(grid, NULL, 0);
  assert_ok(hg_insert(grid, 1, centers, radii));
  assert_pairs(grid, NULL, 0);
  assert_ok(hg_insert(grid, 1, centers + 3, radii));
  assert_pairs(grid, &only, 1);
  hg_destroy(grid);
}

TEST(the_input_is_copied) {
  double centers[6] = {0, 0, 0, 1.5, 0, 0};
  double radii[2] = {1, 1};
  const hg_pair only = {0, 1};
  hg_grid *grid = make_grid(NULL, 2, centers, radii);
  centers[3] = 99;
  radii[0] = 0;
  assert_pairs(grid, &only, 1);
  hg_destroy(grid);
}

TEST(null_is_refused) {
  const double center[3] = {0, 0, 0}, radius = 1;
  hg_grid *grid = make_chain(NULL);
  assert_status(HG_ERR_NULL, hg_insert(NULL, 1, center, &radius));
  assert_status(HG_ERR_NULL, hg_insert(NULL, 0, NULL, NULL));
  assert_status(HG_ERR_NULL, hg_insert(grid, 1, NULL, &radius));
  assert_status(HG_ERR_NULL, hg_insert(grid, 1, center, NULL));
  assert_chain(grid, 0);
  hg_destroy(grid);
}

enum { BATCH = 12, BAD = 7 };

/* Inserts a batch whose row BAD has the given centre component or radius (axis 3), and expects its refusal by index
 * and value; then checks that no particle came in and no id was spent. */
static void refuse_row(int32_t dimension, int axis, double value, const char *text) {
  hg_grid_def def = hg_default_grid_def();
  double centers[3 * BATCH] = {0}, radii[BATCH];
  hg_pair next = {CHAIN_COUNT - 1, CHAIN_COUNT};
  hg_pair expected[CHAIN_COUNT];
  hg_grid *grid;
  int i;
  def.dimension = dimension;
  grid = make_chain(&def);
  for (i = 0; i < BATCH; ++i) radii[i] = 1;
  if (axis == 3) {
    radii[BAD] = value;
  } else {
    centers[BAD * dimension + axis] = value;
  }
  assert_status(HG_ERR_ARGUMENT, hg_insert(grid, BATCH, centers, radii));
  assert_error_names("7");
  assert_error_names(text);
  assert_chain(grid, 0);
  centers[0] = CHAIN_COUNT;
  radii[0] = 0.6;
  assert_ok(hg_insert(grid, 1, centers, radii));
  for (i = 0; i < CHAIN_COUNT - 1; ++i) {
    expected[i].a = i;
    expected[i].b = i + 1;
  }
  expected[CHAIN_COUNT - 1] = next;
  assert_pairs(grid, expected, CHAIN_COUNT);
  hg_destroy(grid);
}

TEST(bad_values_are_named) {
  int axis;
  for (axis = 0; axis < 3; ++axis) {
    refuse_row(3, axis, not_a_number(), "nan");
    refuse_row(3, axis, infinity(), "inf");
    refuse_row(3, axis, -infinity(), "-inf");
  }
  refuse_row(2, 1, not_a_number(), "nan");
  refuse_row(3, 3, not_a_number(), "nan");
  refuse_row(3, 3, infinity(), "inf");
  refuse_row(3, 3, -0.375, "-0.375");
  refuse_row(2, 3, -0.375, "-0.375");
}

TEST(radius_zero_is_a_point) {
  const double centers[9] = {0, 0, 0, 0.5, 0, 0, 0.5, 0, 0};
  const double radii[3] = {1, 0, 0};
  const hg_pair expected[2] = {{0, 1}, {0, 2}};
  hg_grid *grid = make_grid(NULL, 3, centers, radii);
  assert_pairs(grid, expected, 2);
  hg_destroy(grid);
}

TEST(touching_is_no_pair) {
  const double centers[9] = {0, 0, 0, 2, 0, 0, 0, -0.0, 1.9999999999999998};
  const double radii[3] = {1, 1, 1};
  const hg_pair expected[1] = {{0, 2}};
  hg_grid *grid = make_grid(NULL, 3, centers, radii);
  assert_pairs(grid, expected, 1);
  hg_destroy(grid);
}

/* The two largest radii tell whether a pair could meet twice: one giant alone cannot. */
TEST(box_shorter_than_two_reaches) {
  const double centers[6] = {0.1, 0, 0, 0.2, 0, 0};
  const double radii[2] = {0.25, 0.26}, giant = 3;
  const hg_pair expected[1] = {{0, 1}};
  int32_t interaction;
  for (interaction = HG_CONTACT; interaction <= HG_MAX_RANGE; ++interaction) {
    hg_grid_def def = periodic_axis(1, interaction == HG_CONTACT ? 1.0 : 0.5);
    hg_grid *grid;
    def.interaction = interaction;
    grid = make_grid(&def, 1, centers, radii);
    assert_status(HG_ERR_ARGUMENT, hg_insert(grid, 1, centers + 3, radii + 1));
    assert_pairs(grid, NULL, 0);
    assert_ok(hg_insert(grid, 1, centers + 3, radii));
    assert_pairs(grid, expected, 1);
    assert_ok(hg_clear(grid));
    assert_ok(hg_insert(grid, 1, centers, &giant));
    assert_pairs(grid, NULL, 0);
    assert_status(HG_ERR_ARGUMENT, hg_insert(grid, 1, centers + 3, radii));
    hg_destroy(grid);
  }
}

/* A giant that leaves its neighbours' images apart is fine: 2 (0.375 + 0.125) is not longer than the box. */
TEST(one_giant_in_a_short_box) {
  const double centers[6] = {0.1, 0, 0, 0.55, 0, 0};
  const double radii[2] = {0.375, 0.125}, more = 0.126;
  const hg_pair expected[1] = {{0, 1}};
  hg_grid_def def = periodic_axis(0, 1);
  hg_grid *grid = make_grid(&def, 2, centers, radii);
  assert_pairs(grid, expected, 1);
  assert_status(HG_ERR_ARGUMENT, hg_insert(grid, 1, centers, &more));
  assert_non_null(strstr(hg_last_error(), "particles 0 and 2"));
  assert_ok(hg_remove(grid, 1, &expected[0].a));
  assert_ok(hg_insert(grid, 1, centers, &more));
  hg_destroy(grid);
}

/* The margin belongs to the reach. */
TEST(margin_makes_the_box_too_short) {
  const double centers[6] = {0, 0, 0, 0, 0, 0.5}, radii[2] = {0.25, 0.25};
  hg_grid_def def = periodic_axis(2, 1);
  hg_grid *grid;
  def.margin = 0.01;
  grid = make_empty(&def);
  assert_status(HG_ERR_ARGUMENT, hg_insert(grid, 2, centers, radii));
  hg_destroy(grid);
}

TEST(beyond_the_last_user_cell) {
  const double sizes[2] = {0.5, 2};
  const double center[3] = {0, 0, 0}, good = 1, bad = 1.0000001;
  hg_grid_def def = user_levels(sizes, 2);
  hg_grid *grid = make_empty(&def);
  assert_status(HG_ERR_ARGUMENT, hg_insert(grid, 1, center, &bad));
  assert_ok(hg_insert(grid, 1, center, &good));
  hg_destroy(grid);
  def.margin = 0.1; /* which counts not */
  grid = make_empty(&def);
  assert_status(HG_ERR_ARGUMENT, hg_insert(grid, 1, center, &bad));
  assert_ok(hg_insert(grid, 1, center, &good));
  hg_destroy(grid);
}

TEST(too_far_outside_a_periodic_box) {
  const double far[3] = {0, 4294967296.0, 0}, inside[3] = {0, 0.5, 0}, radius = 0.1;
  const hg_grid_def def = periodic_axis(1, 1);
  hg_grid *grid = make_empty(&def);
  assert_status(HG_ERR_LIMIT, hg_insert(grid, 1, far, &radius));
  assert_ok(hg_insert(grid, 1, inside, &radius));
  hg_destroy(grid);
}

/* The arrays are never read: the count alone is too large for the ids. */
TEST(more_than_the_ids_can_count) {
  const double center[3] = {0, 0, 0}, radius = 0.1;
  hg_grid *grid = make_chain(NULL);
  assert_status(HG_ERR_LIMIT, hg_insert(grid, (size_t)INT32_MAX + 1, center, &radius));
  assert_chain(grid, 0);
  hg_destroy(grid);
}

static hg_status insert_again(hg_grid *grid) {
  const double center[3] = {0, 0, 0}, radius = 0.1;
  return hg_insert(grid, 1, center, &radius);
}

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(insert_again); }

static void prepare(hg_grid **grid) {
  *grid = make_chain(NULL);
  assert_chain(*grid, 0);
}

enum { MANY = 300 };

static hg_status insert_many(hg_grid **grid) {
  double centers[3 * MANY], radii[MANY];
  int i;
  for (i = 0; i < MANY; ++i) {
    centers[3 * i] = 10 * i;
    centers[3 * i + 1] = centers[3 * i + 2] = 50;
    radii[i] = 6;
  }
  return hg_insert(*grid, MANY, centers, radii);
}

static void still_a_chain(hg_grid *grid) { assert_chain(grid, 0); }

static void chain_and_row(hg_grid *grid) { assert_int_equal(CHAIN_COUNT - 1 + MANY - 1, pairs_in(grid)); }

TEST(no_memory) {
  const alloc_scenario scenario = {prepare, insert_many, still_a_chain, chain_and_row};
  assert_true(refuse_each_allocation(&scenario) > 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(ids_go_on_counting),
                                     cmocka_unit_test(small_counts),
                                     cmocka_unit_test(the_input_is_copied),
                                     cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(bad_values_are_named),
                                     cmocka_unit_test(radius_zero_is_a_point),
                                     cmocka_unit_test(touching_is_no_pair),
                                     cmocka_unit_test(box_shorter_than_two_reaches),
                                     cmocka_unit_test(one_giant_in_a_short_box),
                                     cmocka_unit_test(margin_makes_the_box_too_short),
                                     cmocka_unit_test(beyond_the_last_user_cell),
                                     cmocka_unit_test(too_far_outside_a_periodic_box),
                                     cmocka_unit_test(more_than_the_ids_can_count),
                                     cmocka_unit_test(refused_inside_a_visitor),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
