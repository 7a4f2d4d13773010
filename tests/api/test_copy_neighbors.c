/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_copy_neighbors: the lists of hg_query_neighbors into arrays of the caller's; the offsets are complete even where
 * there is no room for the ids. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

enum { HALF = CHAIN_COUNT - 1, FULL = 2 * HALF, UNTOUCHED = -77 };

static int32_t row_starts[CHAIN_COUNT + 2], ids[FULL + 1];

static void reset(void) {
  int k;
  for (k = 0; k < CHAIN_COUNT + 2; ++k) row_starts[k] = UNTOUCHED;
  for (k = 0; k <= FULL; ++k) ids[k] = UNTOUCHED;
}

/* Each sphere of the chain meets the one before it and the one after it. */
static void assert_rows(int32_t list, int32_t base, int copied) {
  int32_t entries = 0, sphere;
  for (sphere = 0; sphere < CHAIN_COUNT; ++sphere) {
    assert_int_equal(entries, row_starts[sphere]);
    if (list == HG_FULL && sphere > 0) {
      assert_int_equal(copied ? base + sphere - 1 : UNTOUCHED, ids[entries]);
      ++entries;
    }
    if (sphere + 1 < CHAIN_COUNT) {
      assert_int_equal(copied ? base + sphere + 1 : UNTOUCHED, ids[entries]);
      ++entries;
    }
  }
  assert_int_equal(entries, row_starts[CHAIN_COUNT]);
  assert_int_equal(UNTOUCHED, row_starts[CHAIN_COUNT + 1]);
  assert_int_equal(UNTOUCHED, ids[entries]);
}

TEST(room_enough) {
  int32_t base, list;
  size_t spare, count;
  for (base = 0; base <= 1; ++base) {
    hg_grid_def def = hg_default_grid_def();
    hg_grid *grid;
    def.index_base = base;
    grid = make_chain(&def);
    for (list = HG_HALF; list <= HG_FULL; ++list) {
      const size_t need = list == HG_HALF ? HALF : FULL;
      for (spare = 0; spare <= 1; ++spare) {
        reset();
        assert_ok(hg_copy_neighbors(grid, list, need + spare, row_starts, ids, &count));
        assert_int_equal(need, count);
        assert_rows(list, base, 1);
      }
    }
    hg_destroy(grid);
  }
}

TEST(too_small) {
  hg_grid *grid = make_chain(NULL);
  size_t capacity, count;
  for (capacity = 0; capacity < FULL; ++capacity) {
    reset();
    count = 0;
    assert_status(HG_ERR_CAPACITY, hg_copy_neighbors(grid, HG_FULL, capacity, row_starts, ids, &count));
    assert_error_names("16");
    assert_int_equal(FULL, count);
    assert_rows(HG_FULL, 0, 0);
  }
  reset();
  assert_status(HG_ERR_CAPACITY, hg_copy_neighbors(grid, HG_HALF, 0, row_starts, NULL, &count));
  assert_int_equal(HALF, count);
  assert_rows(HG_HALF, 0, 0);
  hg_destroy(grid);
}

TEST(rows_skip_removed_particles) {
  const int32_t gone[2] = {0, 4};
  const int32_t expected_starts[8] = {0, 1, 3, 4, 5, 7, 9, 10};
  const int32_t expected[10] = {2, 1, 3, 2, 6, 5, 7, 6, 8, 7};
  hg_grid *grid = make_chain(NULL);
  size_t count;
  int k;
  reset();
  assert_ok(hg_remove(grid, 2, gone));
  assert_ok(hg_copy_neighbors(grid, HG_FULL, FULL, row_starts, ids, &count));
  assert_int_equal(10, count);
  for (k = 0; k < 8; ++k) assert_int_equal(expected_starts[k], row_starts[k]);
  for (k = 0; k < 10; ++k) assert_int_equal(expected[k], ids[k]);
  assert_int_equal(UNTOUCHED, row_starts[8]);
  assert_int_equal(UNTOUCHED, ids[10]);
  hg_destroy(grid);
}

TEST(nothing_to_copy) {
  const double center[3] = {0, 0, 0}, radius = 1;
  hg_grid *grid = make_empty(NULL);
  size_t count = 5;
  reset();
  assert_ok(hg_copy_neighbors(grid, HG_FULL, 0, row_starts, NULL, &count));
  assert_int_equal(0, count);
  assert_int_equal(0, row_starts[0]);
  assert_int_equal(UNTOUCHED, row_starts[1]);
  assert_ok(hg_insert(grid, 1, center, &radius));
  count = 5;
  assert_ok(hg_copy_neighbors(grid, HG_HALF, 9, row_starts, ids, &count));
  assert_int_equal(0, count);
  assert_int_equal(0, row_starts[1]);
  assert_int_equal(UNTOUCHED, ids[0]);
  hg_destroy(grid);
}

TEST(bad_arguments) {
  hg_grid *grid = make_chain(NULL);
  size_t count;
  reset();
  assert_status(HG_ERR_NULL, hg_copy_neighbors(NULL, HG_HALF, FULL, row_starts, ids, &count));
  assert_status(HG_ERR_NULL, hg_copy_neighbors(grid, HG_HALF, FULL, NULL, ids, &count));
  assert_error_names("offsets is NULL");
  assert_status(HG_ERR_NULL, hg_copy_neighbors(grid, HG_HALF, FULL, row_starts, ids, NULL));
  assert_status(HG_ERR_ARGUMENT, hg_copy_neighbors(grid, 2, FULL, row_starts, ids, &count));
  assert_error_names("list = 2");
  assert_int_equal(UNTOUCHED, row_starts[0]);
  assert_status(HG_ERR_NULL, hg_copy_neighbors(grid, HG_HALF, FULL, row_starts, NULL, &count));
  assert_error_names("neighbors is NULL");
  hg_destroy(grid);
}

static hg_status copy(hg_grid *grid) {
  size_t count;
  return hg_copy_neighbors(grid, HG_FULL, FULL, row_starts, ids, &count);
}

TEST(no_memory) { assert_true(refuse_each_allocation_on_chain(copy) > 0); }
TEST(refused_inside_a_visitor) { assert_refused_in_visitor(copy); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(room_enough),
                                     cmocka_unit_test(too_small),
                                     cmocka_unit_test(rows_skip_removed_particles),
                                     cmocka_unit_test(nothing_to_copy),
                                     cmocka_unit_test(bad_arguments),
                                     cmocka_unit_test(no_memory),
                                     cmocka_unit_test(refused_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
