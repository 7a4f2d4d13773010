/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_history_clear: all pairs count as new afterwards. */
#include "tests/support/history_fixture.h"

TEST(forgets) {
  const int64_t none[BEFORE_COUNT] = {-1, -1, -1, -1};
  hg_history *history = make_history();
  double item = 1;
  assert_ok(hg_history_clear(history));
  assert_remembers(history, NULL, 0);
  assert_status(HG_ERR_STATE, hg_history_carry(history, sizeof item, &item, NULL));
  assert_update(history, kBefore, BEFORE_COUNT, none);
  hg_history_destroy(history);
}

TEST(null_is_refused) { assert_status(HG_ERR_NULL, hg_history_clear(NULL)); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(forgets), cmocka_unit_test(null_is_refused)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
