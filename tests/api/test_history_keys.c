/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_history_keys: the list that is remembered, if it was given as one of keys. */
#include "tests/support/history_fixture.h"

TEST(gives_the_last_list) {
  hg_history *history = make_keyed_history();
  const hg_pair *pairs = kAfter;
  size_t count = 77;
  assert_remembers_keys(history, kKeysAfter, KEYS_AFTER_COUNT);
  assert_status(HG_ERR_STATE, hg_history_pairs(history, &pairs, &count));
  assert_error_names("the list was given as one of keys, not of pairs");
  assert_true(pairs == kAfter && count == 77);
  hg_history_destroy(history);
}

TEST(a_list_of_pairs_has_none) {
  hg_history *history = make_history();
  const hg_contact_key *keys;
  size_t count;
  assert_status(HG_ERR_STATE, hg_history_keys(history, &keys, &count));
  assert_error_names("the list was given as one of pairs, not of keys");
  hg_history_destroy(history);
}

/* A list of nothing is one of pairs as well as one of keys. */
TEST(a_list_of_nothing) {
  hg_history *history = make_keyed_history();
  const int64_t *previous;
  assert_ok(hg_history_update_keys(history, 0, NULL, &previous));
  assert_remembers(history, NULL, 0);
  assert_remembers_keys(history, NULL, 0);
  hg_history_destroy(history);
}

TEST(null_is_refused) {
  hg_history *history = make_keyed_history();
  const hg_contact_key *keys;
  size_t count;
  assert_status(HG_ERR_NULL, hg_history_keys(NULL, &keys, &count));
  assert_status(HG_ERR_NULL, hg_history_keys(history, NULL, &count));
  assert_status(HG_ERR_NULL, hg_history_keys(history, &keys, NULL));
  hg_history_destroy(history);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(gives_the_last_list), cmocka_unit_test(a_list_of_pairs_has_none),
                                     cmocka_unit_test(a_list_of_nothing), cmocka_unit_test(null_is_refused)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
