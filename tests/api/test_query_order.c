/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_query_order: every id once, near particles together. tests/property/test_spatial_order.cpp measures how near. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

static hg_status query(hg_grid *grid) {
  const int32_t *ids;
  size_t count;
  return hg_query_order(grid, &ids, &count);
}

/* Two groups far apart, their ids mixed: each stands together. */
TEST(groups_stand_together) {
  const double centers[12] = {0, 0, 0, 1e9, 0, 0, 1, 0, 0, 1e9, 1, 0}, radii[4] = {0.6, 0.6, 0.6, 0.6};
  const int32_t *ids;
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  size_t count;
  def.index_base = 1;
  grid = make_grid(&def, 4, centers, radii);
  assert_ok(hg_query_order(grid, &ids, &count));
  assert_int_equal(4, count);
  assert_int_equal(10, ids[0] + ids[1] + ids[2] + ids[3]);
  assert_int_equal(ids[0] % 2, ids[1] % 2);
  assert_int_equal(ids[2] % 2, ids[3] % 2);
  hg_destroy(grid);
}

TEST(ids_that_are_left) {
  const int32_t gone[3] = {0, 4, 8};
  const int32_t *ids;
  int seen[CHAIN_COUNT] = {0};
  hg_grid *grid = make_chain(NULL);
  size_t count, k;
  assert_ok(hg_remove(grid, 3, gone));
  assert_ok(hg_query_order(grid, &ids, &count));
  assert_int_equal(CHAIN_COUNT - 3, count);
  for (k = 0; k < count; ++k) ++seen[ids[k]];
  for (k = 0; k < CHAIN_COUNT; ++k) assert_int_equal(k % 4 != 0, seen[k]);
  assert_ok(hg_set(grid, 0, NULL, NULL));
  assert_ok(hg_query_order(grid, &ids, &count));
  assert_int_equal(0, count);
  assert_null(ids);
  hg_destroy(grid);
}

/* Other queries leave it alone, and so does asking again: another thread may be reading it. */
TEST(borrowed_until_the_grid_changes) {
  const int32_t *ids, *again;
  hg_grid *grid = make_chain(NULL);
  size_t count;
  assert_ok(hg_query_order(grid, &ids, &count));
  ((int32_t *)(uintptr_t)ids)[0] = -1; /* shows whether it is written anew */
  assert_chain(grid, 0);
  assert_ok(hg_query_order(grid, &again, &count));
  assert_ptr_equal(ids, again);
  assert_int_equal(-1, again[0]);
  assert_ok(hg_clear(grid));
  assert_ok(hg_query_order(grid, &ids, &count));
  assert_int_equal(0, count);
  hg_destroy(grid);
}

TEST(null_is_refused) {
  const int32_t *ids;
  hg_grid *grid = make_chain(NULL);
  size_t count;
  assert_status(HG_ERR_NULL, hg_query_order(NULL, &ids, &count));
  assert_status(HG_ERR_NULL, hg_query_order(grid, NULL, &count));
  assert_status(HG_ERR_NULL, hg_query_order(grid, &ids, NULL));
  hg_destroy(grid);
}

TEST(no_memory) { assert_true(refuse_each_allocation_on_chain(query) > 0); }
TEST(refused_inside_a_visitor) { assert_refused_in_visitor(query); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(groups_stand_together),
                                     cmocka_unit_test(ids_that_are_left),
                                     cmocka_unit_test(borrowed_until_the_grid_changes),
                                     cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(no_memory),
                                     cmocka_unit_test(refused_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
