/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_history_restore_keys: a run that goes on from a checkpoint matches as one that never stopped. */
#include "tests/support/history_fixture.h"

TEST(goes_on_from_a_checkpoint) {
  const hg_contact_key next[2] = {{9, 9, 9}, {1, 2, 3}};
  hg_history *history = make_empty_history();
  const int64_t *previous;
  assert_ok(hg_history_restore_keys(history, KEYS_AFTER_COUNT, kKeysAfter));
  assert_remembers_keys(history, kKeysAfter, KEYS_AFTER_COUNT);
  assert_ok(hg_history_update_keys(history, 2, next, &previous));
  assert_int_equal(-1, previous[0]);
  assert_int_equal(1, previous[1]);
  hg_history_destroy(history);
}

TEST(wrong_arguments) {
  const hg_contact_key twice[2] = {{1, 2, 4}, {1, 2, 4}};
  hg_history *history = make_history();
  assert_status(HG_ERR_NULL, hg_history_restore_keys(NULL, 0, NULL));
  assert_status(HG_ERR_NULL, hg_history_restore_keys(history, 1, NULL));
  assert_status(HG_ERR_ARGUMENT, hg_history_restore_keys(history, 2, twice));
  assert_error_names("keys[1] = (1, 2, 4) is already listed as keys[0]");
  assert_history(history);
  hg_history_destroy(history);
}

static hg_status restore_keys(hg_history *history, size_t count, const hg_pair *pairs) {
  return hg_history_restore_keys(history, count, keys_of(count, pairs));
}

TEST(no_memory) { assert_true(refuse_each_allocation_for_many(restore_keys) > 0); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(goes_on_from_a_checkpoint), cmocka_unit_test(wrong_arguments),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
