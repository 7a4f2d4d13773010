/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_history_ended_keys: which contacts of a list of keys the last update no longer found. */
#include "tests/support/history_fixture.h"

TEST(contacts_that_are_no_more) {
  const hg_pair next[2] = {{1, 2}, {5, 6}};
  const int64_t places_of_all[KEYS_AFTER_COUNT] = {0, 1, 2};
  hg_history *history = make_keyed_history();
  const hg_contact_key *keys;
  const int64_t *places, *previous;
  size_t count;
  assert_ok(hg_history_ended_keys(history, &keys, &places, &count));
  assert_int_equal(1, count);
  assert_memory_equal(&kKeysBefore[1], keys, sizeof *keys);
  assert_int_equal(1, places[0]);
  assert_ok(hg_history_update(history, 2, next, &previous));
  assert_ok(hg_history_ended_keys(history, &keys, &places, &count));
  assert_int_equal(KEYS_AFTER_COUNT, count);
  assert_memory_equal(kKeysAfter, keys, sizeof kKeysAfter);
  assert_memory_equal(places_of_all, places, sizeof places_of_all);
  hg_history_destroy(history);
}

TEST(wrong_arguments) {
  hg_history *history = make_history();
  const hg_contact_key *keys;
  const int64_t *places;
  size_t count;
  assert_status(HG_ERR_NULL, hg_history_ended_keys(NULL, &keys, &places, &count));
  assert_status(HG_ERR_NULL, hg_history_ended_keys(history, NULL, &places, &count));
  assert_status(HG_ERR_NULL, hg_history_ended_keys(history, &keys, NULL, &count));
  assert_status(HG_ERR_NULL, hg_history_ended_keys(history, &keys, &places, NULL));
  assert_status(HG_ERR_STATE, hg_history_ended_keys(history, &keys, &places, &count));
  assert_error_names("the list before was given as one of pairs, not of keys");
  hg_history_destroy(history);
  history = make_empty_history();
  assert_status(HG_ERR_STATE, hg_history_ended_keys(history, &keys, &places, &count));
  hg_history_destroy(history);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(contacts_that_are_no_more), cmocka_unit_test(wrong_arguments)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
