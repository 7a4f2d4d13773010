/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_history_restore: a run that goes on from a checkpoint matches as one that never stopped. */
#include "tests/support/history_fixture.h"

TEST(goes_on_from_a_checkpoint) {
  const int64_t places[AFTER_COUNT] = {2, -1, 0, -1, -1};
  hg_history *history = make_empty_history();
  assert_ok(hg_history_restore(history, BEFORE_COUNT, kBefore));
  assert_remembers(history, kBefore, BEFORE_COUNT);
  assert_update(history, kAfter, AFTER_COUNT, places);
  assert_history(history);
  hg_history_destroy(history);
}

TEST(replaces_what_was_there) {
  const int64_t none[AFTER_COUNT] = {-1, -1, -1, -1, -1};
  hg_history *history = make_history();
  assert_ok(hg_history_restore(history, 1, kBefore + 1));
  assert_remembers(history, kBefore + 1, 1);
  assert_update(history, kAfter, AFTER_COUNT, none);
  assert_ok(hg_history_restore(history, 0, NULL));
  assert_remembers(history, NULL, 0);
  hg_history_destroy(history);
}

TEST(wrong_arguments) {
  const hg_pair twice[3] = {{1, 2}, {2, 3}, {1, 2}};
  hg_history *history = make_history();
  assert_status(HG_ERR_NULL, hg_history_restore(NULL, 0, NULL));
  assert_status(HG_ERR_NULL, hg_history_restore(history, 1, NULL));
  assert_status(HG_ERR_ARGUMENT, hg_history_restore(history, 3, twice));
  assert_error_names("pairs[2] = (1, 2) is already listed as pairs[0]");
  assert_history(history);
  hg_history_destroy(history);
}

TEST(no_memory) { assert_true(refuse_each_allocation_for_many(hg_history_restore) > 0); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(goes_on_from_a_checkpoint),
                                     cmocka_unit_test(replaces_what_was_there), cmocka_unit_test(wrong_arguments),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
