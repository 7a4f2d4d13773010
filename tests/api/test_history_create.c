/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_history_create: an empty list, and memory from the hooks. */
#include "tests/support/failing_alloc.h"
#include "tests/support/history_fixture.h"

TEST(starts_empty) {
  hg_history *history = make_empty_history();
  double one = 1;
  assert_remembers(history, NULL, 0);
  assert_status(HG_ERR_STATE, hg_history_carry(history, sizeof one, NULL, &one));
  hg_history_destroy(history);
}

TEST(null_is_refused) { assert_status(HG_ERR_NULL, hg_history_create(NULL)); }

TEST(no_memory) {
  hg_history *history = (hg_history *)(uintptr_t)0x10;
  failing_alloc_install();
  failing_alloc_arm(0);
  assert_status(HG_ERR_MEMORY, hg_history_create(&history));
  assert_null(history);
  failing_alloc_arm(-1);
  history = make_history();
  assert_true(failing_alloc_books().live_bytes >= (long long)(AFTER_COUNT * 32));
  hg_history_destroy(history);
  assert_int_equal(0, failing_alloc_books().live_blocks);
  failing_alloc_remove();
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(starts_empty), cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
