/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_history_destroy: NULL, and every byte given back to the allocator that the history was created with. */
#include "tests/support/failing_alloc.h"
#include "tests/support/history_fixture.h"

TEST(null_is_fine) { hg_history_destroy(NULL); }

TEST(frees_everything) {
  hg_history *empty, *full;
  failing_alloc_install();
  empty = make_empty_history();
  full = make_history();
  failing_alloc_remove();
  assert_true(failing_alloc_books().live_blocks > 2);
  hg_history_destroy(empty);
  hg_history_destroy(full);
  assert_int_equal(0, failing_alloc_books().live_blocks);
  assert_int_equal(0, failing_alloc_books().live_bytes);
  assert_int_equal(0, failing_alloc_books().faults);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(null_is_fine), cmocka_unit_test(frees_everything)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
