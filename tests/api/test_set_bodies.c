/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_set_bodies: parts of one body are no pair. tests/property/lives.cpp compares the pairs of any bodies with brute
 * force. */
#include "tests/support/failing_alloc.h"
#include "tests/support/two_pairs.h"

/* 0 1 2 | 3 4 | 5 | 6 | 7 8, the middle ones of no body. */
static const int32_t kBodies[CHAIN_COUNT] = {7, 7, 7, 0, 0, -1, -1, INT32_MAX, INT32_MAX};
static const hg_pair kBetween[4] = {{2, 3}, {4, 5}, {5, 6}, {6, 7}};

static hg_status set_chain_bodies(hg_grid *grid) { return hg_set_bodies(grid, CHAIN_COUNT, kBodies); }

TEST(parts_of_one_body_are_no_pair) {
  hg_grid *grid = make_chain(NULL);
  assert_ok(set_chain_bodies(grid));
  assert_pairs(grid, kBetween, 4);
  assert_ok(hg_set_bodies(grid, 0, NULL));
  assert_chain(grid, 0);
  hg_destroy(grid);
}

/* A particle and its own image are of one body, if of any. */
TEST(own_images_are_hidden) {
  const double center[3] = {0.5, 0, 0}, radius = 0.6;
  const int32_t body = 3, none = -1;
  const hg_pair self = {0, 0};
  hg_grid_def def = periodic_axis(0, 1);
  hg_grid *grid;
  def.images = HG_ALL_IMAGES;
  grid = make_grid(&def, 1, center, &radius);
  assert_pairs(grid, &self, 1);
  assert_ok(hg_set_bodies(grid, 1, &body));
  assert_pairs(grid, NULL, 0);
  assert_ok(hg_set_bodies(grid, 1, &none));
  assert_pairs(grid, &self, 1);
  hg_destroy(grid);
}

TEST(bodies_follow_their_particles) {
  const int32_t bodies[4] = {1, 1, 2, 3}, gone = 2;
  const double near_0[3] = {0, 0.5, 0}, radius = 0.6;
  const hg_pair with_new[2] = {{0, 4}, {1, 4}};
  hg_grid *grid = make_grid(NULL, 4, kStart, kRadii);
  assert_ok(hg_set_bodies(grid, 4, bodies));
  assert_pairs(grid, kStartPairs + 1, 1);
  assert_ok(hg_remove(grid, 1, &gone));
  assert_pairs(grid, NULL, 0);
  assert_ok(hg_insert(grid, 1, near_0, &radius)); /* reaches 0 and 1, and is of no body */
  assert_pairs(grid, with_new, 2);
  assert_ok(hg_set(grid, 4, kStart, kRadii)); /* as many as there were: 1, 1, 3, none */
  assert_pairs(grid, kStartPairs + 1, 1);
  assert_ok(hg_set(grid, 2, kStart, kRadii));
  assert_pairs(grid, kStartPairs, 1);
  hg_destroy(grid);
}

TEST(bad_ones_are_refused) {
  const int32_t good[4] = {5, 5, -1, 9}, bad[4] = {5, 5, 5, -2};
  hg_grid *grid = make_grid(NULL, 4, kStart, kRadii);
  assert_ok(hg_set_bodies(grid, 4, good));
  assert_status(HG_ERR_ARGUMENT, hg_set_bodies(grid, 4, bad));
  assert_error_names("bodies[3] = -2");
  assert_status(HG_ERR_ARGUMENT, hg_set_bodies(grid, 5, good));
  assert_error_names("count is 5");
  assert_status(HG_ERR_NULL, hg_set_bodies(NULL, 4, good));
  assert_pairs(grid, kStartPairs + 1, 1);
  hg_destroy(grid);
}

/* A body for each leaves the chain as it is. */
static hg_status set_and_query(hg_grid *grid) {
  const int32_t bodies[CHAIN_COUNT] = {8, 7, 6, 5, 4, 3, 2, 1, 0};
  const hg_pair *pairs;
  size_t count;
  const hg_status status = hg_set_bodies(grid, CHAIN_COUNT, bodies);
  return status != HG_OK ? status : hg_query_pairs(grid, &pairs, &count);
}

TEST(no_memory) { assert_true(refuse_each_allocation_on_chain(set_and_query) > 0); }
TEST(refused_inside_a_visitor) { assert_refused_in_visitor(set_chain_bodies); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(parts_of_one_body_are_no_pair),
                                     cmocka_unit_test(own_images_are_hidden),
                                     cmocka_unit_test(bodies_follow_their_particles),
                                     cmocka_unit_test(bad_ones_are_refused),
                                     cmocka_unit_test(no_memory),
                                     cmocka_unit_test(refused_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
