/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_destroy: NULL, an empty grid, a grid with results, and a call from inside a visitor. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

#include <string.h>

TEST(null_is_fine) { hg_destroy(NULL); }

TEST(frees_everything) {
  hg_grid *empty, *full;
  failing_alloc_install();
  empty = make_empty(NULL);
  full = make_chain(NULL);
  assert_ok(search(full));
  assert_true(failing_alloc_books().live_blocks > 0);
  hg_destroy(empty);
  hg_destroy(full);
  assert_int_equal(0, failing_alloc_books().live_blocks);
  assert_int_equal(0, failing_alloc_books().live_bytes);
  failing_alloc_remove();
}

static int32_t destroy_grid(void *context, const hg_pair *pairs, size_t count) {
  (void)pairs;
  (void)count;
  hg_destroy(context);
  return 0;
}

TEST(ignored_inside_a_visitor) {
  hg_grid *grid = make_chain(NULL);
  assert_ok(hg_visit_pairs(grid, destroy_grid, grid));
  assert_true(strlen(hg_last_error()) > 0);
  assert_chain(grid, 0);
  hg_destroy(grid);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(null_is_fine), cmocka_unit_test(frees_everything),
                                     cmocka_unit_test(ignored_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
