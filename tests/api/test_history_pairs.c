/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_history_pairs: the list that is remembered. */
#include "tests/support/history_fixture.h"

TEST(gives_the_last_list) {
  hg_history *history = make_empty_history();
  const int64_t none[BEFORE_COUNT] = {-1, -1, -1, -1};
  assert_remembers(history, NULL, 0);
  assert_update(history, kBefore, BEFORE_COUNT, none);
  assert_remembers(history, kBefore, BEFORE_COUNT);
  assert_update(history, NULL, 0, NULL);
  assert_remembers(history, NULL, 0);
  hg_history_destroy(history);
}

TEST(null_is_refused) {
  hg_history *history = make_history();
  const hg_pair *pairs;
  size_t count;
  assert_status(HG_ERR_NULL, hg_history_pairs(NULL, &pairs, &count));
  assert_status(HG_ERR_NULL, hg_history_pairs(history, NULL, &count));
  assert_status(HG_ERR_NULL, hg_history_pairs(history, &pairs, NULL));
  assert_history(history);
  hg_history_destroy(history);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(gives_the_last_list), cmocka_unit_test(null_is_refused)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
