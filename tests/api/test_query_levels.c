/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_query_levels: the levels of the built grid, finest first. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

#include <math.h>

/* Ten small spheres in a row and one large one. */
enum { COUNT = 11 };
static hg_grid *make_two_sizes(const hg_grid_def *def) {
  double centers[3 * COUNT] = {0}, radii[COUNT];
  int i;
  for (i = 0; i < COUNT; ++i) {
    centers[3 * i] = 4 * i;
    radii[i] = i == COUNT - 1 ? 8 : 0.5;
  }
  return make_grid(def, COUNT, centers, radii);
}

TEST(two_sizes_make_two_levels) {
  hg_grid_def def = hg_default_grid_def();
  const hg_level *levels;
  hg_grid *grid;
  size_t count;
  def.level_rule = HG_LEVELS_PAPER;
  def.level_count = 2;
  def.cell_overhead = 0;
  def.box_max[0] = def.box_max[1] = def.box_max[2] = 64;
  grid = make_two_sizes(&def);
  assert_ok(hg_query_levels(grid, &levels, &count));
  assert_int_equal(2, count);
  assert_true(levels[0].cell_size == 1);
  assert_true(levels[1].cell_size == 16);
  assert_true(levels[0].largest_radius == 0.5);
  assert_true(levels[1].largest_radius == 8);
  assert_int_equal(COUNT - 1, levels[0].particle_count);
  assert_int_equal(1, levels[1].particle_count);
  /* m_h = N_h s_h^3 / V with V = 64^3 */
  assert_true(fabs(levels[0].occupancy * 262144 - (COUNT - 1)) < 1e-9);
  assert_true(fabs(levels[1].occupancy * 262144 - 4096) < 1e-9);
  hg_destroy(grid);
}

TEST(every_particle_is_on_its_level) {
  const double sizes[4] = {0.5, 2, 4, 32};
  const hg_grid_def def = user_levels(sizes, 4);
  hg_grid *grid = make_two_sizes(&def);
  const hg_level *levels;
  size_t count;
  assert_ok(hg_query_levels(grid, &levels, &count));
  assert_int_equal(4, count);
  assert_int_equal(0, levels[0].particle_count);
  assert_int_equal(COUNT - 1, levels[1].particle_count);
  assert_int_equal(0, levels[2].particle_count);
  assert_int_equal(1, levels[3].particle_count);
  assert_true(levels[0].largest_radius == 0);
  assert_true(levels[3].largest_radius == 8);
  assert_true(levels[1].cell_size == 2);
  hg_destroy(grid);
}

/* Cells hold the diameters, and the margin with them. */
TEST(cells_hold_the_reach) {
  int32_t rule, interaction;
  for (rule = HG_LEVELS_AUTO; rule <= HG_LEVELS_PAPER; ++rule) {
    for (interaction = HG_CONTACT; interaction <= HG_MAX_RANGE; ++interaction) {
      hg_grid_def def = hg_default_grid_def();
      const hg_level *levels;
      int64_t particles = 0;
      hg_grid *grid;
      size_t count, h;
      def.level_rule = rule;
      def.interaction = interaction;
      def.margin = 0.25;
      grid = make_two_sizes(&def);
      assert_ok(hg_query_levels(grid, &levels, &count));
      assert_true(count >= 1);
      for (h = 0; h < count; ++h) {
        const double reach = levels[h].largest_radius * (interaction == HG_CONTACT ? 2 : 1) + 0.25;
        particles += levels[h].particle_count;
        assert_true(levels[h].cell_size >= reach);
        assert_true(h == 0 || levels[h].cell_size > levels[h - 1].cell_size);
      }
      assert_int_equal(COUNT, particles);
      hg_destroy(grid);
    }
  }
}

TEST(empty_grid) {
  hg_grid *grid = make_empty(NULL);
  const hg_level *levels;
  size_t count = 77;
  assert_ok(hg_query_levels(grid, &levels, &count));
  assert_true(count <= 1);
  hg_destroy(grid);
}

TEST(null_is_refused) {
  hg_grid *grid = make_chain(NULL);
  const hg_level *levels;
  size_t count;
  assert_status(HG_ERR_NULL, hg_query_levels(NULL, &levels, &count));
  assert_status(HG_ERR_NULL, hg_query_levels(grid, NULL, &count));
  assert_status(HG_ERR_NULL, hg_query_levels(grid, &levels, NULL));
  hg_destroy(grid);
}

static hg_status query_again(hg_grid *grid) {
  const hg_level *levels;
  size_t count;
  return hg_query_levels(grid, &levels, &count);
}

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(query_again); }

TEST(no_memory) { assert_true(refuse_each_allocation_on_chain(query_again) > 0); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(two_sizes_make_two_levels),
                                     cmocka_unit_test(every_particle_is_on_its_level),
                                     cmocka_unit_test(cells_hold_the_reach),
                                     cmocka_unit_test(empty_grid),
                                     cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(refused_inside_a_visitor),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
