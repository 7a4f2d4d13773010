/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_create: every member of the definition, in and out of its range. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

#include <string.h>

TEST(null_def_means_defaults) {
  hg_grid *grid = make_chain(NULL);
  assert_chain(grid, 0);
  hg_destroy(grid);
}

TEST(null_grid_is_refused) {
  const hg_grid_def def = hg_default_grid_def();
  assert_status(HG_ERR_NULL, hg_create(&def, NULL));
  assert_status(HG_ERR_NULL, hg_create(NULL, NULL));
}

/* The call fails, *grid becomes NULL and the text names the member. */
static void refuse(hg_status status, const hg_grid_def *def, const char *member) {
  hg_grid *grid = (hg_grid *)(uintptr_t)0x10;
  assert_status(status, hg_create(def, &grid));
  assert_null(grid);
  assert_error_names(member);
}

TEST(zeroed_or_foreign_def_is_refused) {
  hg_grid_def def;
  memset(&def, 0, sizeof def);
  refuse(HG_ERR_ARGUMENT, &def, "struct_size");
  def = hg_default_grid_def();
  def.struct_size = 8;
  refuse(HG_ERR_ARGUMENT, &def, "struct_size");
  def.struct_size = sizeof def + 8;
  refuse(HG_ERR_ARGUMENT, &def, "struct_size");
}

#define REFUSE_MEMBER(member, value)          \
  do {                                        \
    hg_grid_def def_ = hg_default_grid_def(); \
    def_.member = (value);                    \
    refuse(HG_ERR_ARGUMENT, &def_, #member);  \
  } while (0)
#define ACCEPT_MEMBER(member, value)          \
  do {                                        \
    hg_grid_def def_ = hg_default_grid_def(); \
    def_.member = (value);                    \
    hg_destroy(make_empty(&def_));            \
  } while (0)

TEST(integers_out_of_range) {
  REFUSE_MEMBER(dimension, 1);
  REFUSE_MEMBER(dimension, 4);
  REFUSE_MEMBER(dimension, -3);
  REFUSE_MEMBER(thread_count, -1);
  REFUSE_MEMBER(thread_count, 1025);
  REFUSE_MEMBER(index_base, -1);
  REFUSE_MEMBER(index_base, 2);
  REFUSE_MEMBER(interaction, -1);
  REFUSE_MEMBER(interaction, 2);
  REFUSE_MEMBER(accuracy, -1);
  REFUSE_MEMBER(accuracy, 3);
  REFUSE_MEMBER(pair_order, -1);
  REFUSE_MEMBER(pair_order, 2);
  REFUSE_MEMBER(level_rule, -1);
  REFUSE_MEMBER(level_rule, 3);
  REFUSE_MEMBER(level_count, -1);
  REFUSE_MEMBER(reserved0, 1);
  REFUSE_MEMBER(reserved1, -1);
}

TEST(integers_in_range) {
  ACCEPT_MEMBER(dimension, 2);
  ACCEPT_MEMBER(dimension, 3);
  ACCEPT_MEMBER(thread_count, 1);
  ACCEPT_MEMBER(thread_count, 1024);
  ACCEPT_MEMBER(index_base, 1);
  ACCEPT_MEMBER(interaction, HG_MAX_RANGE);
  ACCEPT_MEMBER(accuracy, HG_DOUBLE);
  ACCEPT_MEMBER(accuracy, HG_FLOAT);
  ACCEPT_MEMBER(pair_order, HG_ORDER_ID);
  ACCEPT_MEMBER(level_rule, HG_LEVELS_PAPER);
  ACCEPT_MEMBER(level_count, HG_MAX_LEVELS);
}

TEST(lengths_out_of_range) {
  REFUSE_MEMBER(margin, -1e-300);
  REFUSE_MEMBER(margin, not_a_number());
  REFUSE_MEMBER(margin, infinity());
  REFUSE_MEMBER(skin, -0.5);
  REFUSE_MEMBER(skin, not_a_number());
  REFUSE_MEMBER(skin, infinity());
  REFUSE_MEMBER(cell_overhead, not_a_number());
  REFUSE_MEMBER(cell_overhead, infinity());
  ACCEPT_MEMBER(margin, 0.5);
  ACCEPT_MEMBER(skin, 0.5);
  ACCEPT_MEMBER(cell_overhead, 0);
  ACCEPT_MEMBER(cell_overhead, 0.3);
  ACCEPT_MEMBER(cell_overhead, -7);
  REFUSE_MEMBER(level_price, not_a_number());
  REFUSE_MEMBER(row_price, infinity());
  ACCEPT_MEMBER(level_price, 0);
  ACCEPT_MEMBER(row_price, 1e308);
}

TEST(value_is_in_the_text) {
  hg_grid_def def = hg_default_grid_def();
  def.margin = -0.125;
  refuse(HG_ERR_ARGUMENT, &def, "-0.125");
  def.margin = 0;
  def.dimension = 42;
  refuse(HG_ERR_ARGUMENT, &def, "42");
}

TEST(periodic_axis_needs_a_box) {
  int axis;
  for (axis = 0; axis < 3; ++axis) {
    hg_grid_def def = hg_default_grid_def();
    def.periodic[axis] = 1;
    refuse(HG_ERR_ARGUMENT, &def, "box");
    def.box_min[axis] = 2;
    def.box_max[axis] = 1;
    refuse(HG_ERR_ARGUMENT, &def, "box");
    def.box_max[axis] = not_a_number();
    refuse(HG_ERR_ARGUMENT, &def, "box");
    def.box_max[axis] = infinity();
    refuse(HG_ERR_ARGUMENT, &def, "box");
    def.box_max[axis] = 3;
    def.box_min[axis] = -infinity();
    refuse(HG_ERR_ARGUMENT, &def, "box");
    def.box_min[axis] = 2;
    hg_destroy(make_empty(&def));
    def.periodic[axis] = 2;
    refuse(HG_ERR_ARGUMENT, &def, "periodic");
    def.periodic[axis] = -1;
    refuse(HG_ERR_ARGUMENT, &def, "periodic");
  }
}

TEST(too_many_levels) {
  hg_grid_def def = hg_default_grid_def();
  double sizes[HG_MAX_LEVELS + 1];
  int k;
  for (k = 0; k <= HG_MAX_LEVELS; ++k) sizes[k] = k + 1;
  def.level_count = HG_MAX_LEVELS + 1;
  refuse(HG_ERR_LIMIT, &def, "level_count");
  def.level_rule = HG_LEVELS_PAPER;
  refuse(HG_ERR_LIMIT, &def, "level_count");
  def = user_levels(sizes, HG_MAX_LEVELS + 1);
  refuse(HG_ERR_LIMIT, &def, "level_count");
  def.level_count = HG_MAX_LEVELS;
  hg_destroy(make_empty(&def));
}

TEST(user_levels_must_ascend) {
  double bad[6][3] = {{1, 3, 2}, {1, 2, 2}, {0, 1, 2}, {-1, 1, 2}, {1, 2, 0}, {1, 2, 0}};
  hg_grid_def def;
  int k;
  bad[4][2] = not_a_number();
  bad[5][2] = infinity();
  for (k = 0; k < 6; ++k) {
    def = user_levels(bad[k], 3);
    refuse(HG_ERR_ARGUMENT, &def, "cell_sizes");
  }
  def = user_levels(NULL, 3);
  refuse(HG_ERR_NULL, &def, "cell_sizes");
  def = user_levels(bad[0], 0);
  refuse(HG_ERR_ARGUMENT, &def, "level_count");
}

TEST(user_levels_are_copied) {
  double sizes[] = {0.5, 1.5};
  hg_grid_def def = user_levels(sizes, 2);
  hg_grid *grid = make_empty(&def);
  const hg_level *levels;
  size_t count;
  sizes[0] = sizes[1] = -1;
  def.level_count = 0;
  assert_ok(hg_query_levels(grid, &levels, &count));
  assert_int_equal(2, count);
  assert_true(levels[0].cell_size == 0.5);
  assert_true(levels[1].cell_size == 1.5);
  hg_destroy(grid);
}

static hg_status create_with_levels(hg_grid **grid) {
  static const double sizes[] = {0.5, 1, 1.5};
  hg_grid_def def = user_levels(sizes, 3);
  def.thread_count = 2;
  return hg_create(&def, grid);
}

static void still_null(hg_grid *grid) { assert_null(grid); }

TEST(no_memory) {
  const alloc_scenario scenario = {NULL, create_with_levels, still_null, NULL};
  assert_true(refuse_each_allocation(&scenario) > 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(null_def_means_defaults),
                                     cmocka_unit_test(null_grid_is_refused),
                                     cmocka_unit_test(zeroed_or_foreign_def_is_refused),
                                     cmocka_unit_test(integers_out_of_range),
                                     cmocka_unit_test(integers_in_range),
                                     cmocka_unit_test(lengths_out_of_range),
                                     cmocka_unit_test(value_is_in_the_text),
                                     cmocka_unit_test(periodic_axis_needs_a_box),
                                     cmocka_unit_test(too_many_levels),
                                     cmocka_unit_test(user_levels_must_ascend),
                                     cmocka_unit_test(user_levels_are_copied),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
