/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_history_ended: which contacts the last update no longer found. */
#include "tests/support/history_fixture.h"

static void assert_ended(hg_history *history, const hg_pair *expected, const int64_t *expected_places, size_t count) {
  const hg_pair *pairs = (const hg_pair *)(uintptr_t)0x10;
  const int64_t *places = (const int64_t *)(uintptr_t)0x10;
  size_t found = 77, k;
  assert_ok(hg_history_ended(history, &pairs, &places, &found));
  assert_int_equal(count, found);
  if (count == 0) assert_true(pairs == NULL && places == NULL);
  for (k = 0; k < count; ++k) {
    assert_int_equal(expected[k].a, pairs[k].a);
    assert_int_equal(expected[k].b, pairs[k].b);
    assert_int_equal(expected_places[k], places[k]);
  }
}

/* What ended between kBefore and kAfter. */
static void assert_ended_of_fixture(hg_history *history) {
  const hg_pair ended[2] = {{7, 9}, {2147483647, -2147483647 - 1}};
  const int64_t places[2] = {1, 3};
  assert_ended(history, ended, places, 2);
}

TEST(contacts_that_are_no_more) {
  hg_history *history = make_history();
  const int64_t *previous;
  const int64_t all[AFTER_COUNT] = {0, 1, 2, 3, 4};
  assert_ended_of_fixture(history);
  assert_ended_of_fixture(history);
  assert_update(history, kAfter, AFTER_COUNT, all);
  assert_ended(history, NULL, NULL, 0);
  assert_ok(hg_history_update(history, 0, NULL, &previous));
  assert_ended(history, kAfter, all, AFTER_COUNT);
  assert_ok(hg_history_update(history, 0, NULL, &previous));
  assert_ended(history, NULL, NULL, 0);
  hg_history_destroy(history);
}

/* A list that is refused leaves the answer as it was, whether asked before or not. */
TEST(failures_change_nothing) {
  const hg_pair twice[4] = {{50, 51}, {7, 9}, {8, 8}, {7, 9}};
  hg_history *history = make_history();
  const int64_t *previous;
  int time;
  for (time = 0; time < 2; ++time) {
    assert_status(HG_ERR_ARGUMENT, hg_history_update(history, 4, twice, &previous));
    assert_status(HG_ERR_ARGUMENT, hg_history_restore(history, 4, twice));
    assert_ended_of_fixture(history);
  }
  hg_history_destroy(history);
}

TEST(nothing_was_matched) {
  hg_history *history = make_empty_history();
  const hg_pair *pairs;
  const int64_t *places;
  size_t count;
  assert_status(HG_ERR_STATE, hg_history_ended(history, &pairs, &places, &count));
  assert_error_names("no list has been matched");
  hg_history_destroy(history);
  history = make_history();
  assert_ok(hg_history_restore(history, BEFORE_COUNT, kBefore));
  assert_status(HG_ERR_STATE, hg_history_ended(history, &pairs, &places, &count));
  hg_history_destroy(history);
}

TEST(wrong_arguments) {
  hg_history *history = make_history();
  const hg_pair *pairs;
  const int64_t *places;
  size_t count;
  assert_status(HG_ERR_NULL, hg_history_ended(NULL, &pairs, &places, &count));
  assert_status(HG_ERR_NULL, hg_history_ended(history, NULL, &places, &count));
  assert_status(HG_ERR_NULL, hg_history_ended(history, &pairs, NULL, &count));
  assert_status(HG_ERR_NULL, hg_history_ended(history, &pairs, &places, NULL));
  assert_ended_of_fixture(history);
  hg_history_destroy(history);
}

/* The former list was one of keys: hg_history_ended_keys knows. */
TEST(keys_are_no_pairs) {
  hg_history *history = make_keyed_history();
  const hg_pair *pairs;
  const int64_t *places;
  size_t count;
  assert_status(HG_ERR_STATE, hg_history_ended(history, &pairs, &places, &count));
  assert_error_names("the list before was given as one of keys, not of pairs");
  hg_history_destroy(history);
}

static hg_status ask(hg_history *history, size_t count, const hg_pair *unused) {
  const hg_pair *pairs;
  const int64_t *places;
  (void)count;
  (void)unused;
  return hg_history_ended(history, &pairs, &places, &count);
}

TEST(no_memory) { assert_true(refuse_each_allocation_of(ask, assert_ended_of_fixture) >= 3); }

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(contacts_that_are_no_more), cmocka_unit_test(failures_change_nothing),
      cmocka_unit_test(nothing_was_matched),       cmocka_unit_test(wrong_arguments),
      cmocka_unit_test(keys_are_no_pairs),         cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
