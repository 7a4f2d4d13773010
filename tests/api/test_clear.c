/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_clear: an empty grid whose ids start anew. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

static void fill_again(hg_grid *grid, int32_t first) {
  double centers[3 * CHAIN_COUNT] = {0}, radii[CHAIN_COUNT];
  int i;
  for (i = 0; i < CHAIN_COUNT; ++i) {
    centers[3 * i] = i;
    radii[i] = 0.6;
  }
  assert_ok(hg_insert(grid, CHAIN_COUNT, centers, radii));
  assert_chain(grid, first);
}

TEST(ids_start_anew) {
  int32_t base;
  for (base = 0; base <= 1; ++base) {
    hg_grid_def def = hg_default_grid_def();
    hg_grid *grid;
    int round;
    def.index_base = base;
    grid = make_chain(&def);
    for (round = 0; round < 3; ++round) {
      const int32_t id = base;
      assert_chain(grid, base);
      assert_ok(hg_clear(grid));
      assert_pairs(grid, NULL, 0);
      assert_status(HG_ERR_NOT_FOUND, hg_remove(grid, 1, &id));
      fill_again(grid, base);
    }
    hg_destroy(grid);
  }
}

/* A grid that was cleared may take other sizes than before, here much larger ones. */
TEST(other_sizes_may_follow) {
  const double centers[6] = {0, 0, 0, 1e6, 0, 0}, radii[2] = {6e5, 6e5};
  const hg_pair expected = {0, 1};
  hg_grid *grid = make_chain(NULL);
  assert_chain(grid, 0);
  assert_ok(hg_clear(grid));
  assert_ok(hg_insert(grid, 2, centers, radii));
  assert_pairs(grid, &expected, 1);
  hg_destroy(grid);
}

TEST(memory_is_kept) {
  hg_grid *grid;
  long long calls;
  failing_alloc_install();
  grid = make_chain(NULL);
  assert_chain(grid, 0);
  calls = failing_alloc_books().calls;
  assert_ok(hg_clear(grid));
  assert_int_equal(calls, failing_alloc_books().calls);
  assert_ok(hg_clear(grid));
  hg_destroy(grid);
  assert_int_equal(0, failing_alloc_books().live_blocks);
  failing_alloc_remove();
}

TEST(null_is_refused) { assert_status(HG_ERR_NULL, hg_clear(NULL)); }

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(hg_clear); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(ids_start_anew), cmocka_unit_test(other_sizes_may_follow),
                                     cmocka_unit_test(memory_is_kept), cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(refused_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
