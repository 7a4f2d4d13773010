/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_get_stats: the counters, and callers with shorter structs. */
#include "tests/support/fixture.h"

#include <string.h>

TEST(zero_before_the_first_search) {
  hg_grid *grid = make_chain(NULL);
  hg_grid_stats stats;
  memset(&stats, 0xff, sizeof stats);
  assert_ok(hg_get_stats(grid, &stats, sizeof stats));
  assert_int_equal(CHAIN_COUNT, stats.particle_count);
  assert_int_equal(0, stats.candidate_count);
  assert_int_equal(0, stats.undecided_count);
  assert_int_equal(0, stats.exact_count);
  assert_int_equal(0, stats.pair_count);
  assert_int_equal(0, stats.build_count);
  assert_int_equal(0, stats.search_count);
  assert_true(stats.byte_count > 0);
  hg_destroy(grid);
}

TEST(counters_fit_together) {
  hg_grid *grid = make_chain(NULL);
  hg_grid_stats stats;
  assert_chain(grid, 0);
  assert_ok(hg_get_stats(grid, &stats, sizeof stats));
  assert_int_equal(CHAIN_COUNT, stats.particle_count);
  assert_int_equal(CHAIN_COUNT - 1, stats.pair_count);
  assert_int_equal(1, stats.build_count);
  assert_int_equal(1, stats.search_count);
  assert_true(stats.candidate_count >= stats.pair_count);
  assert_true(stats.undecided_count <= stats.candidate_count);
  assert_true(stats.exact_count <= stats.undecided_count);
  assert_int_equal(1, stats.level_count);
  assert_true(stats.row_count >= 1 && stats.row_count <= CHAIN_COUNT);
  assert_true(stats.cell_count >= stats.row_count);
  assert_true(stats.byte_count >= (int64_t)((CHAIN_COUNT - 1) * sizeof(hg_pair)));
  hg_destroy(grid);
}

/* Spheres that exactly touch cannot be told from overlapping ones by any fast test. */
TEST(touching_pairs_are_undecided) {
  const double centers[6] = {0, 0, 0, 2, 0, 0}, radii[2] = {1, 1};
  hg_grid *grid = make_grid(NULL, 2, centers, radii);
  hg_grid_stats stats;
  assert_pairs(grid, NULL, 0);
  assert_ok(hg_get_stats(grid, &stats, sizeof stats));
  assert_int_equal(1, stats.candidate_count);
  assert_int_equal(1, stats.undecided_count);
  hg_destroy(grid);
}

TEST(far_apart_is_never_tested) {
  enum { COUNT = 1000 };
  static double centers[3 * COUNT], radii[COUNT];
  hg_grid_stats stats;
  hg_grid *grid;
  int i;
  for (i = 0; i < COUNT; ++i) {
    centers[3 * i] = 1e6 * i;
    radii[i] = 1;
  }
  grid = make_grid(NULL, COUNT, centers, radii);
  assert_pairs(grid, NULL, 0);
  assert_ok(hg_get_stats(grid, &stats, sizeof stats));
  assert_int_equal(0, stats.candidate_count);
  assert_true(stats.cell_count <= 9 * COUNT); /* memory follows the particles, not the extent */
  hg_destroy(grid);
}

TEST(changes_show) {
  const int32_t gone = 0;
  hg_grid *grid = make_chain(NULL);
  hg_grid_stats stats;
  assert_ok(hg_remove(grid, 1, &gone));
  assert_ok(hg_get_stats(grid, &stats, sizeof stats));
  assert_int_equal(CHAIN_COUNT - 1, stats.particle_count);
  assert_ok(hg_clear(grid));
  assert_ok(hg_get_stats(grid, &stats, sizeof stats));
  assert_int_equal(0, stats.particle_count);
  hg_destroy(grid);
}

TEST(a_shorter_struct_gets_its_part) {
  hg_grid *grid = make_chain(NULL);
  hg_grid_stats stats;
  size_t byte;
  memset(&stats, 0x5a, sizeof stats);
  assert_ok(hg_get_stats(grid, &stats, sizeof stats.particle_count));
  assert_int_equal(CHAIN_COUNT, stats.particle_count);
  for (byte = sizeof stats.particle_count; byte < sizeof stats; ++byte) {
    assert_int_equal(0x5a, ((unsigned char *)&stats)[byte]);
  }
  hg_destroy(grid);
}

TEST(bad_arguments) {
  hg_grid *grid = make_chain(NULL);
  hg_grid_stats stats;
  assert_status(HG_ERR_NULL, hg_get_stats(NULL, &stats, sizeof stats));
  assert_status(HG_ERR_NULL, hg_get_stats(grid, NULL, sizeof stats));
  assert_status(HG_ERR_ARGUMENT, hg_get_stats(grid, &stats, 0));
  assert_status(HG_ERR_ARGUMENT, hg_get_stats(grid, &stats, sizeof stats + 8));
  hg_destroy(grid);
}

static hg_status stats_again(hg_grid *grid) {
  hg_grid_stats stats;
  return hg_get_stats(grid, &stats, sizeof stats);
}

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(stats_again); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(zero_before_the_first_search),
                                     cmocka_unit_test(counters_fit_together),
                                     cmocka_unit_test(touching_pairs_are_undecided),
                                     cmocka_unit_test(far_apart_is_never_tested),
                                     cmocka_unit_test(changes_show),
                                     cmocka_unit_test(a_shorter_struct_gets_its_part),
                                     cmocka_unit_test(bad_arguments),
                                     cmocka_unit_test(refused_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
