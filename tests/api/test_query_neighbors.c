/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_query_neighbors: half and full lists in compressed rows. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

TEST(half_list_of_a_chain) {
  hg_grid *grid = make_chain(NULL);
  const int64_t *offsets;
  const int32_t *neighbors;
  int i;
  assert_ok(hg_query_neighbors(grid, HG_HALF, &offsets, &neighbors));
  for (i = 0; i < CHAIN_COUNT; ++i) assert_int_equal(i, offsets[i]);
  assert_int_equal(CHAIN_COUNT - 1, offsets[CHAIN_COUNT]);
  for (i = 0; i < CHAIN_COUNT - 1; ++i) assert_int_equal(i + 1, neighbors[i]);
  hg_destroy(grid);
}

TEST(full_list_of_a_chain) {
  int32_t base;
  for (base = 0; base <= 1; ++base) {
    hg_grid_def def = hg_default_grid_def();
    const int64_t *offsets;
    const int32_t *neighbors;
    hg_grid *grid;
    int i;
    def.index_base = base;
    grid = make_chain(&def);
    assert_ok(hg_query_neighbors(grid, HG_FULL, &offsets, &neighbors));
    assert_int_equal(0, offsets[0]);
    for (i = 0; i < CHAIN_COUNT; ++i) {
      int64_t k = offsets[i];
      if (i > 0) assert_int_equal(base + i - 1, neighbors[k++]);
      if (i < CHAIN_COUNT - 1) assert_int_equal(base + i + 1, neighbors[k++]);
      assert_int_equal(k, offsets[i + 1]);
    }
    hg_destroy(grid);
  }
}

/* Rows belong to the live particles in ascending id; entries are ids. */
TEST(rows_skip_removed_particles) {
  const int32_t gone[2] = {0, 4};
  const int64_t expected_offsets[8] = {0, 1, 3, 4, 5, 7, 9, 10};
  const int32_t expected[10] = {2, 1, 3, 2, 6, 5, 7, 6, 8, 7};
  hg_grid *grid = make_chain(NULL);
  const int64_t *offsets;
  const int32_t *neighbors;
  int k;
  assert_ok(hg_remove(grid, 2, gone));
  assert_ok(hg_query_neighbors(grid, HG_FULL, &offsets, &neighbors));
  for (k = 0; k < 8; ++k) assert_int_equal(expected_offsets[k], offsets[k]);
  for (k = 0; k < 10; ++k) assert_int_equal(expected[k], neighbors[k]);
  hg_destroy(grid);
}

TEST(empty_and_lonely) {
  const double center[3] = {0, 0, 0}, radius = 1;
  hg_grid *grid = make_empty(NULL);
  const int64_t *offsets = NULL;
  const int32_t *neighbors;
  int32_t list;
  for (list = HG_HALF; list <= HG_FULL; ++list) {
    assert_ok(hg_query_neighbors(grid, list, &offsets, &neighbors));
    assert_non_null(offsets);
    assert_int_equal(0, offsets[0]);
  }
  assert_ok(hg_insert(grid, 1, center, &radius));
  assert_ok(hg_query_neighbors(grid, HG_FULL, &offsets, &neighbors));
  assert_int_equal(0, offsets[0]);
  assert_int_equal(0, offsets[1]);
  hg_destroy(grid);
}

TEST(lists_alternate) {
  hg_grid *grid = make_chain(NULL);
  const int64_t *offsets;
  const int32_t *neighbors;
  int round;
  for (round = 0; round < 4; ++round) {
    const int32_t list = round % 2 == 0 ? HG_FULL : HG_HALF;
    assert_ok(hg_query_neighbors(grid, list, &offsets, &neighbors));
    assert_int_equal((CHAIN_COUNT - 1) * (list == HG_FULL ? 2 : 1), offsets[CHAIN_COUNT]);
    assert_chain(grid, 0);
  }
  hg_destroy(grid);
}

TEST(bad_arguments) {
  hg_grid *grid = make_chain(NULL);
  const int64_t *offsets;
  const int32_t *neighbors;
  assert_status(HG_ERR_NULL, hg_query_neighbors(NULL, HG_HALF, &offsets, &neighbors));
  assert_status(HG_ERR_NULL, hg_query_neighbors(grid, HG_HALF, NULL, &neighbors));
  assert_status(HG_ERR_NULL, hg_query_neighbors(grid, HG_HALF, &offsets, NULL));
  assert_status(HG_ERR_ARGUMENT, hg_query_neighbors(grid, -1, &offsets, &neighbors));
  assert_error_names("list");
  assert_status(HG_ERR_ARGUMENT, hg_query_neighbors(grid, 2, &offsets, &neighbors));
  assert_error_names("2");
  hg_destroy(grid);
}

static hg_status query_again(hg_grid *grid) {
  const int64_t *offsets;
  const int32_t *neighbors;
  return hg_query_neighbors(grid, HG_FULL, &offsets, &neighbors);
}

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(query_again); }

TEST(no_memory) { assert_true(refuse_each_allocation_on_chain(query_again) > 0); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(half_list_of_a_chain),
                                     cmocka_unit_test(full_list_of_a_chain),
                                     cmocka_unit_test(rows_skip_removed_particles),
                                     cmocka_unit_test(empty_and_lonely),
                                     cmocka_unit_test(lists_alternate),
                                     cmocka_unit_test(bad_arguments),
                                     cmocka_unit_test(refused_inside_a_visitor),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
