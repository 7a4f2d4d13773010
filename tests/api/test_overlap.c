/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_overlap: the grid's verdict on two spheres that it need not hold. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

static const double kOrigin[3] = {0, 0, 0}, kAhead[3] = {2, 0, 0};

static int overlap(hg_grid *grid, const double *a, double ra, const double *b, double rb) {
  int32_t overlaps = -7, reverse = -7;
  assert_ok(hg_overlap(grid, a, ra, b, rb, &overlaps));
  assert_ok(hg_overlap(grid, b, rb, a, ra, &reverse));
  assert_int_equal(overlaps, reverse);
  return overlaps;
}

TEST(the_rule_of_the_grid) {
  const double just = 1 + 0x1p-52;
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid = make_empty(NULL);
  assert_int_equal(0, overlap(grid, kOrigin, 1, kAhead, 1));
  assert_int_equal(1, overlap(grid, kOrigin, 1, kAhead, just));
  assert_int_equal(1, overlap(grid, kOrigin, 1, kOrigin, 0));
  assert_int_equal(0, overlap(grid, kOrigin, 0, kOrigin, 0));
  hg_destroy(grid);
  def.touching = 1;
  grid = make_empty(&def);
  assert_int_equal(1, overlap(grid, kOrigin, 1, kAhead, 1));
  assert_int_equal(1, overlap(grid, kOrigin, 0, kOrigin, 0));
  hg_destroy(grid);
  def.touching = 0;
  def.margin = 0.5;
  grid = make_empty(&def);
  assert_int_equal(1, overlap(grid, kOrigin, 1, kAhead, 0.75));
  assert_int_equal(0, overlap(grid, kOrigin, 1, kAhead, 0.5));
  hg_destroy(grid);
  def.interaction = HG_MAX_RANGE;
  grid = make_empty(&def);
  assert_int_equal(0, overlap(grid, kOrigin, 1.5, kAhead, 1.5));
  assert_int_equal(1, overlap(grid, kOrigin, 1.75, kAhead, 0));
  hg_destroy(grid);
}

/* Through any image, wherever the spheres are, in 2D without a third coordinate. */
TEST(across_the_box) {
  const double left[2] = {0.25, 5}, right[2] = {-10.5, 5}, above[2] = {0.25, 15};
  hg_grid_def def = periodic_axis(0, 10);
  hg_grid *grid;
  def.dimension = 2;
  grid = make_empty(&def);
  assert_int_equal(1, overlap(grid, left, 0.5, right, 0.5));
  assert_int_equal(0, overlap(grid, left, 0.25, right, 0.5));
  assert_int_equal(0, overlap(grid, left, 4, above, 4));
  assert_int_equal(1, overlap(grid, left, 100, right, 0)); /* larger than the box */
  hg_destroy(grid);
}

TEST(the_particles_do_not_matter) {
  hg_grid *grid = make_chain(NULL);
  assert_int_equal(0, overlap(grid, kOrigin, 1, kAhead, 1));
  assert_int_equal(1, overlap(grid, kOrigin, 1, kAhead, 2));
  assert_int_equal(0, stats_of(grid).build_count);
  assert_chain(grid, 0);
  hg_destroy(grid);
}

TEST(null_is_refused) {
  int32_t overlaps;
  hg_grid *grid = make_chain(NULL);
  assert_status(HG_ERR_NULL, hg_overlap(NULL, kOrigin, 1, kAhead, 1, &overlaps));
  assert_status(HG_ERR_NULL, hg_overlap(grid, NULL, 1, kAhead, 1, &overlaps));
  assert_status(HG_ERR_NULL, hg_overlap(grid, kOrigin, 1, NULL, 1, &overlaps));
  assert_status(HG_ERR_NULL, hg_overlap(grid, kOrigin, 1, kAhead, 1, NULL));
  hg_destroy(grid);
}

TEST(bad_values_are_refused) {
  const hg_grid_def def = periodic_axis(0, 1);
  double bad[3] = {0, 0, 0}, far[3] = {1e13, 0, 0};
  int32_t overlaps = 5;
  hg_grid *grid = make_empty(&def);
  bad[1] = not_a_number();
  assert_status(HG_ERR_ARGUMENT, hg_overlap(grid, bad, 1, kAhead, 1, &overlaps));
  assert_error_names("center_a[1] = nan");
  assert_status(HG_ERR_ARGUMENT, hg_overlap(grid, kAhead, 1, bad, 1, &overlaps));
  assert_error_names("center_b[1] = nan");
  assert_status(HG_ERR_ARGUMENT, hg_overlap(grid, kAhead, -0.25, kAhead, 1, &overlaps));
  assert_error_names("radius_a = -0.25");
  assert_status(HG_ERR_ARGUMENT, hg_overlap(grid, kAhead, 1, kAhead, infinity(), &overlaps));
  assert_error_names("radius_b = inf");
  assert_status(HG_ERR_ARGUMENT, hg_overlap(grid, far, 1, kAhead, 1, &overlaps));
  assert_error_names("center_a[0]");
  assert_int_equal(5, overlaps);
  hg_destroy(grid);
}

static hg_status ask(hg_grid *grid) {
  int32_t overlaps;
  return hg_overlap(grid, kOrigin, 1, kAhead, 1, &overlaps);
}

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(ask); }

TEST(needs_no_memory) { assert_int_equal(0, refuse_each_allocation_on_chain(ask)); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(the_rule_of_the_grid),
                                     cmocka_unit_test(across_the_box),
                                     cmocka_unit_test(the_particles_do_not_matter),
                                     cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(bad_values_are_refused),
                                     cmocka_unit_test(refused_inside_a_visitor),
                                     cmocka_unit_test(needs_no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
