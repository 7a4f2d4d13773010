/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */
#include "tests/support/history_fixture.h"

#include "tests/support/failing_alloc.h"

/* Two pairs stay, the other way round; (7, 9) is not (9, 7). */
const hg_pair kBefore[BEFORE_COUNT] = {{1, 2}, {7, 9}, {3, 4}, {2147483647, -2147483647 - 1}};
const hg_pair kAfter[AFTER_COUNT] = {{3, 4}, {9, 7}, {1, 2}, {0, 0}, {-1, -1}};

const hg_contact_key kKeysBefore[KEYS_BEFORE_COUNT] = {{1, 2, 3}, {1, 2, 4}};
const hg_contact_key kKeysAfter[KEYS_AFTER_COUNT] = {{1, 2, 5}, {1, 2, 3}, {9, 1, (int64_t)1 << 50}};

hg_history *make_empty_history(void) {
  hg_history *history = NULL;
  assert_ok(hg_history_create(&history));
  assert_non_null(history);
  return history;
}

void assert_update(hg_history *history, const hg_pair *pairs, size_t count, const int64_t *expected) {
  const int64_t *previous = (const int64_t *)(uintptr_t)0x10;
  size_t k;
  assert_ok(hg_history_update(history, count, pairs, &previous));
  if (count == 0) assert_null(previous);
  for (k = 0; k < count; ++k) assert_int_equal(expected[k], previous[k]);
}

hg_history *make_history(void) {
  const int64_t none[BEFORE_COUNT] = {-1, -1, -1, -1}, places[AFTER_COUNT] = {2, -1, 0, -1, -1};
  hg_history *history = make_empty_history();
  assert_update(history, kBefore, BEFORE_COUNT, none);
  assert_update(history, kAfter, AFTER_COUNT, places);
  return history;
}

hg_history *make_keyed_history(void) {
  const int64_t *previous;
  hg_history *history = make_empty_history();
  assert_ok(hg_history_update_keys(history, KEYS_BEFORE_COUNT, kKeysBefore, &previous));
  assert_ok(hg_history_update_keys(history, KEYS_AFTER_COUNT, kKeysAfter, &previous));
  assert_true(previous[0] == -1 && previous[1] == 0 && previous[2] == -1);
  return history;
}

void assert_remembers(const hg_history *history, const hg_pair *pairs, size_t count) {
  const hg_pair *remembered = (const hg_pair *)(uintptr_t)0x10;
  size_t remembered_count = 77, k;
  assert_ok(hg_history_pairs(history, &remembered, &remembered_count));
  assert_int_equal(count, remembered_count);
  if (count == 0) assert_null(remembered);
  for (k = 0; k < count; ++k) {
    assert_int_equal(pairs[k].a, remembered[k].a);
    assert_int_equal(pairs[k].b, remembered[k].b);
  }
}

void assert_remembers_keys(const hg_history *history, const hg_contact_key *keys, size_t count) {
  const hg_contact_key *remembered = (const hg_contact_key *)(uintptr_t)0x10;
  size_t remembered_count = 77;
  assert_ok(hg_history_keys(history, &remembered, &remembered_count));
  assert_int_equal(count, remembered_count);
  if (count == 0) {
    assert_null(remembered);
  } else {
    assert_memory_equal(keys, remembered, count * sizeof *keys);
  }
}

void assert_history(const hg_history *history) {
  const double before[BEFORE_COUNT] = {10, 11, 12, 13}, expected[AFTER_COUNT] = {12, 0, 10, 0, 0};
  double after[AFTER_COUNT] = {-1, -1, -1, -1, -1};
  assert_remembers(history, kAfter, AFTER_COUNT);
  assert_ok(hg_history_carry(history, sizeof before[0], before, after));
  assert_memory_equal(expected, after, sizeof expected);
}

const hg_pair *many_pairs(void) {
  static hg_pair many[MANY];
  int k;
  for (k = 0; k < MANY; ++k) {
    many[k].a = k;
    many[k].b = 7 * k + 1;
  }
  return many;
}

const hg_contact_key *keys_of(size_t count, const hg_pair *pairs) {
  static hg_contact_key keys[MANY];
  size_t k;
  for (k = 0; k < count; ++k) {
    keys[k].a = pairs[k].a;
    keys[k].b = pairs[k].b;
    keys[k].sub = 5 - (int64_t)k;
    if (keys[k].sub <= 0) --keys[k].sub;
  }
  return keys;
}

/* The scenarios of failing_alloc.h are about grids: the history stands beside them. */
static hg_history *watched;
static history_call *watched_call;
static void (*watched_check)(hg_history *history);
static void prepare(hg_grid **grid) {
  (void)grid;
  watched = make_history();
}
static hg_status act(hg_grid **grid) {
  (void)grid;
  return watched_call(watched, MANY, many_pairs());
}
static void unchanged(hg_grid *grid) {
  const hg_pair *pairs;
  const int64_t *places;
  size_t count;
  (void)grid;
  assert_history(watched);
  assert_ok(hg_history_ended(watched, &pairs, &places, &count));
  assert_true(count == 2 && pairs[0].a == 7 && pairs[0].b == 9 && places[0] == 1 && places[1] == 3);
}
static void done(hg_grid *grid) {
  (void)grid;
  watched_check(watched);
  hg_history_destroy(watched);
}

long long refuse_each_allocation_of(history_call *call, void (*check)(hg_history *history)) {
  const alloc_scenario scenario = {prepare, act, unchanged, done};
  watched_call = call;
  watched_check = check;
  return refuse_each_allocation(&scenario);
}

/* As pairs or as keys, whichever it holds. */
static void assert_remembers_many(hg_history *history) {
  const hg_pair *pairs;
  size_t count;
  if (hg_history_pairs(history, &pairs, &count) == HG_OK) {
    assert_remembers(history, many_pairs(), MANY);
  } else {
    assert_remembers_keys(history, keys_of(MANY, many_pairs()), MANY);
  }
}

long long refuse_each_allocation_for_many(history_call *call) {
  return refuse_each_allocation_of(call, assert_remembers_many);
}
