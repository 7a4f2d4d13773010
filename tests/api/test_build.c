/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_build: makes the grid ready, searches nothing, and repeats only after a change. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

#include <pthread.h>

TEST(builds_once_and_searches_nothing) {
  hg_grid *grid = make_chain(NULL);
  assert_int_equal(0, stats_of(grid).build_count);
  assert_ok(hg_build(grid));
  assert_int_equal(1, stats_of(grid).build_count);
  assert_int_equal(0, stats_of(grid).search_count);
  assert_ok(hg_build(grid));
  assert_chain(grid, 0);
  assert_int_equal(1, stats_of(grid).build_count);
  assert_int_equal(1, stats_of(grid).search_count);
  hg_destroy(grid);
}

TEST(a_change_asks_for_another) {
  const int32_t last = CHAIN_COUNT - 1;
  hg_grid *grid = make_chain(NULL);
  assert_ok(hg_build(grid));
  assert_ok(hg_remove(grid, 1, &last));
  assert_ok(hg_build(grid));
  assert_int_equal(2, stats_of(grid).build_count);
  hg_destroy(grid);
}

TEST(empty_and_tiny_grids) {
  const double center[3] = {1e300, -1e300, 5e-324}, radius = 0;
  hg_grid *grid = make_empty(NULL);
  assert_ok(hg_build(grid));
  assert_int_equal(0, stats_of(grid).particle_count);
  assert_ok(hg_insert(grid, 1, center, &radius));
  assert_ok(hg_build(grid));
  assert_int_equal(1, stats_of(grid).particle_count);
  assert_pairs(grid, NULL, 0);
  hg_destroy(grid);
}

TEST(null_is_refused) { assert_status(HG_ERR_NULL, hg_build(NULL)); }

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(hg_build); }

enum { READERS = 4, ROUNDS = 50 };

typedef struct reader {
  hg_grid *grid;
  int (*read)(hg_grid *grid);
  int wrong;
} reader;

static void *read_often(void *argument) {
  reader *r = argument;
  int round;
  for (round = 0; round < ROUNDS; ++round) r->wrong += !r->read(r->grid);
  return NULL;
}

/* Reading calls need no lock of the caller once the grid is built. */
static void assert_several_may(int (*read)(hg_grid *grid)) {
  hg_grid *grid = make_chain(NULL);
  pthread_t threads[READERS];
  reader readers[READERS];
  int k;
  assert_ok(hg_build(grid));
  for (k = 0; k < READERS; ++k) {
    readers[k].grid = grid;
    readers[k].read = read;
    readers[k].wrong = 0;
    assert_int_equal(0, pthread_create(&threads[k], NULL, read_often, &readers[k]));
  }
  for (k = 0; k < READERS; ++k) assert_int_equal(0, pthread_join(threads[k], NULL));
  for (k = 0; k < READERS; ++k) assert_int_equal(0, readers[k].wrong);
  hg_destroy(grid);
}

static int finds_spheres(hg_grid *grid) {
  const double center[3] = {4, 0, 0};
  const int32_t *ids;
  size_t count;
  return hg_query_sphere(grid, center, 0.5, &ids, &count) == HG_OK && count == 3 && ids[0] == 3 && ids[2] == 5;
}

static int finds_pairs(hg_grid *grid) {
  const hg_pair *pairs;
  size_t count;
  return hg_query_pairs(grid, &pairs, &count) == HG_OK && count == CHAIN_COUNT - 1;
}

TEST(several_threads_may_read) { assert_several_may(finds_spheres); }

TEST(several_threads_may_ask_for_pairs) { assert_several_may(finds_pairs); }

TEST(no_memory) { assert_true(refuse_each_allocation_on_chain(hg_build) > 0); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(builds_once_and_searches_nothing),
                                     cmocka_unit_test(a_change_asks_for_another),
                                     cmocka_unit_test(empty_and_tiny_grids),
                                     cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(refused_inside_a_visitor),
                                     cmocka_unit_test(several_threads_may_read),
                                     cmocka_unit_test(several_threads_may_ask_for_pairs),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
