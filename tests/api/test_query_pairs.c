/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_query_pairs: orders, interactions, margin, borrowed results. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

#include <stdlib.h>
#include <string.h>

TEST(zero_one_two_particles) {
  const double centers[6] = {0, 0, 0, 0, 0, 0}, radii[2] = {1, 1};
  const hg_pair coincident = {0, 1};
  const hg_pair *pairs = (const hg_pair *)(uintptr_t)0x10;
  hg_grid *grid = make_empty(NULL);
  size_t count = 77;
  assert_ok(hg_query_pairs(grid, &pairs, &count));
  assert_int_equal(0, count);
  assert_ok(hg_insert(grid, 1, centers, radii));
  assert_pairs(grid, NULL, 0);
  assert_ok(hg_insert(grid, 1, centers, radii));
  assert_pairs(grid, &coincident, 1);
  hg_destroy(grid);
}

TEST(null_is_refused) {
  const hg_pair *pairs;
  hg_grid *grid = make_chain(NULL);
  size_t count;
  assert_status(HG_ERR_NULL, hg_query_pairs(NULL, &pairs, &count));
  assert_status(HG_ERR_NULL, hg_query_pairs(grid, NULL, &count));
  assert_status(HG_ERR_NULL, hg_query_pairs(grid, &pairs, NULL));
  assert_chain(grid, 0);
  hg_destroy(grid);
}

/* A random but fixed cloud of N equal spheres; large enough for several rows and cells. */
enum { CLOUD = 500 };
static hg_grid *make_cloud(const hg_grid_def *def) {
  double centers[3 * CLOUD], radii[CLOUD];
  uint32_t word = 12345;
  int i;
  for (i = 0; i < 3 * CLOUD; ++i) {
    word = word * 1664525U + 1013904223U;
    centers[i] = 8.0 * (word >> 8) / 16777216.0;
  }
  for (i = 0; i < CLOUD; ++i) radii[i] = i % 10 == 0 ? 1.0 : 0.2;
  return make_grid(def, CLOUD, centers, radii);
}

TEST(id_order_ascends) {
  int32_t threads;
  for (threads = 1; threads <= 3; ++threads) {
    hg_grid_def def = hg_default_grid_def();
    const hg_pair *pairs;
    hg_grid *grid;
    size_t count, k;
    def.pair_order = HG_ORDER_ID;
    def.thread_count = threads;
    grid = make_cloud(&def);
    assert_ok(hg_query_pairs(grid, &pairs, &count));
    assert_true(count > CLOUD / 2);
    for (k = 0; k < count; ++k) assert_true(pairs[k].a < pairs[k].b);
    for (k = 1; k < count; ++k) {
      assert_true(pairs[k - 1].a < pairs[k].a || (pairs[k - 1].a == pairs[k].a && pairs[k - 1].b < pairs[k].b));
    }
    hg_destroy(grid);
  }
}

TEST(a_second_call_returns_the_same_list) {
  int32_t order;
  for (order = HG_ORDER_GRID; order <= HG_ORDER_ID; ++order) {
    hg_grid_def def = hg_default_grid_def();
    const hg_pair *first, *second;
    hg_grid *grid;
    size_t first_count, second_count;
    hg_pair *copy;
    def.pair_order = order;
    grid = make_cloud(&def);
    assert_ok(hg_query_pairs(grid, &first, &first_count));
    copy = malloc(first_count * sizeof *copy);
    assert_non_null(copy);
    memcpy(copy, first, first_count * sizeof *copy);
    assert_ok(hg_query_pairs(grid, &second, &second_count));
    assert_int_equal(first_count, second_count);
    assert_memory_equal(copy, second, first_count * sizeof *copy);
    assert_int_equal(first_count, stats_of(grid).pair_count);
    free(copy);
    hg_destroy(grid);
  }
}

/* Twins: the same bytes from another grid with the same input, also in grid order. */
TEST(equal_grids_give_equal_bytes) {
  hg_grid *one = make_cloud(NULL), *two = make_cloud(NULL);
  const hg_pair *p, *q;
  size_t p_count, q_count;
  assert_ok(hg_query_pairs(one, &p, &p_count));
  assert_ok(hg_query_pairs(two, &q, &q_count));
  assert_int_equal(p_count, q_count);
  assert_memory_equal(p, q, p_count * sizeof *p);
  hg_destroy(one);
  hg_destroy(two);
}

/* A large sphere, a small one inside its range, two small ones near each other outside of it. */
static const double kCenters[12] = {0, 0, 0, 2.5, 0, 0, 9, 0, 0, 9.375, 0, 0};
static const double kRadii[4] = {3, 0.25, 0.25, 0.25};

TEST(contact_and_max_range_differ) {
  const hg_pair contacts[2] = {{0, 1}, {2, 3}}, ranges[1] = {{0, 1}};
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid = make_grid(&def, 4, kCenters, kRadii);
  assert_pairs(grid, contacts, 2);
  hg_destroy(grid);
  def.interaction = HG_MAX_RANGE;
  grid = make_grid(&def, 4, kCenters, kRadii);
  assert_pairs(grid, ranges, 1);
  hg_destroy(grid);
}

TEST(margin_adds_to_every_reach) {
  const hg_pair contacts[4] = {{0, 1}, {0, 2}, {1, 2}, {2, 3}}, ranges[2] = {{0, 1}, {2, 3}};
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  def.margin = 6.0625; /* 2.5 to 9 is 6.5 < 6.0625 + 0.5; 2.5 to 9.375 is 6.875 */
  grid = make_grid(&def, 4, kCenters, kRadii);
  assert_pairs(grid, contacts, 4);
  hg_destroy(grid);
  def.interaction = HG_MAX_RANGE;
  def.margin = 0.25;
  grid = make_grid(&def, 4, kCenters, kRadii);
  assert_pairs(grid, ranges, 2);
  hg_destroy(grid);
}

TEST(two_dimensions) {
  const double centers[6] = {0, 0, 3, 4, -3, -4.0000001};
  const double radii[3] = {2.5, 2.5000001, 2.5};
  const hg_pair expected[1] = {{0, 1}};
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  def.dimension = 2;
  grid = make_grid(&def, 3, centers, radii);
  assert_pairs(grid, expected, 1);
  hg_destroy(grid);
}

TEST(across_a_periodic_face) {
  const double centers[9] = {0.25, 5, 5, 9.5, 5, 5, 29.25, 5, 5};
  const double radii[3] = {0.5, 0.5, 0.5};
  const hg_pair expected[2] = {{0, 1}, {1, 2}};
  const hg_grid_def def = periodic_axis(0, 10);
  hg_grid *grid = make_grid(&def, 3, centers, radii);
  assert_pairs(grid, expected, 2); /* 0.25 and 29.25 exactly touch through the face */
  hg_destroy(grid);
}

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(search); }

static void prepare(hg_grid **grid) {
  hg_grid_def def = hg_default_grid_def();
  def.pair_order = HG_ORDER_ID;
  *grid = make_chain(&def);
}
static void prepare_built(hg_grid **grid) {
  prepare(grid);
  assert_ok(hg_build(*grid));
}
static hg_status query(hg_grid **grid) { return search(*grid); }
static void still_a_chain(hg_grid *grid) { assert_chain(grid, 0); }

TEST(no_memory) {
  const alloc_scenario unbuilt = {prepare, query, NULL, still_a_chain};
  const alloc_scenario built = {prepare_built, query, NULL, still_a_chain};
  assert_true(refuse_each_allocation(&unbuilt) > 0);
  assert_true(refuse_each_allocation(&built) > 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(zero_one_two_particles),
                                     cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(id_order_ascends),
                                     cmocka_unit_test(a_second_call_returns_the_same_list),
                                     cmocka_unit_test(equal_grids_give_equal_bytes),
                                     cmocka_unit_test(contact_and_max_range_differ),
                                     cmocka_unit_test(margin_adds_to_every_reach),
                                     cmocka_unit_test(two_dimensions),
                                     cmocka_unit_test(across_a_periodic_face),
                                     cmocka_unit_test(refused_inside_a_visitor),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
