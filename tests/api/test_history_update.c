/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_history_update: places of pairs in the list before, through changed order, removal and failures. */
#include "tests/support/failing_alloc.h"
#include "tests/support/history_fixture.h"

#include <stdlib.h>

TEST(finds_places) {
  const hg_pair last[2] = {{0, 0}, {1, 2}};
  const int64_t places[2] = {3, 2};
  hg_history *history = make_history();
  assert_history(history);
  assert_update(history, last, 2, places);
  hg_history_destroy(history);
}

TEST(empty_lists) {
  const int64_t none[BEFORE_COUNT] = {-1, -1, -1, -1};
  hg_history *history = make_empty_history();
  assert_update(history, NULL, 0, NULL);
  assert_update(history, kBefore, BEFORE_COUNT, none);
  assert_update(history, NULL, 0, NULL);
  assert_remembers(history, NULL, 0);
  assert_update(history, kBefore, BEFORE_COUNT, none);
  hg_history_destroy(history);
}

/* The list of a checkpoint may come from the history itself. */
TEST(its_own_list) {
  const int64_t same[AFTER_COUNT] = {0, 1, 2, 3, 4};
  hg_history *history = make_history();
  const hg_pair *pairs;
  size_t count;
  assert_ok(hg_history_pairs(history, &pairs, &count));
  assert_update(history, pairs, count, same);
  assert_remembers(history, kAfter, AFTER_COUNT);
  hg_history_destroy(history);
}

TEST(null_is_refused) {
  const int64_t *previous;
  hg_history *history = make_history();
  assert_status(HG_ERR_NULL, hg_history_update(NULL, 1, kBefore, &previous));
  assert_status(HG_ERR_NULL, hg_history_update(history, 1, NULL, &previous));
  assert_status(HG_ERR_NULL, hg_history_update(history, 1, kBefore, NULL));
  assert_history(history);
  hg_history_destroy(history);
}

/* A pair that comes twice is found whether it was in the list before or not, whatever stands between. */
TEST(a_pair_twice_is_refused) {
  const hg_pair lists[4][4] = {{{5, 6}, {3, 4}, {5, 6}, {0, 0}}, /* new, new */
                               {{3, 4}, {3, 4}, {1, 2}, {0, 0}}, /* old, side by side */
                               {{3, 4}, {9, 7}, {1, 2}, {9, 7}}, /* old, in order the first time */
                               {{-1, -1}, {1, 2}, {8, 8}, {1, 2}} /* old, out of order both times */};
  const char *const texts[4] = {
      "pairs[2] = (5, 6) is already listed as pairs[0]", "pairs[1] = (3, 4) is already listed as pairs[0]",
      "pairs[3] = (9, 7) is already listed as pairs[1]", "pairs[3] = (1, 2) is already listed as pairs[1]"};
  hg_history *history = make_history();
  int k;
  for (k = 0; k < 4; ++k) {
    const int64_t *previous;
    assert_status(HG_ERR_ARGUMENT, hg_history_update(history, 4, lists[k], &previous));
    assert_error_names(texts[k]);
    assert_history(history);
  }
  hg_history_destroy(history);
}

/* Particles leave a grid and others come, with gaps in the ids and the order turned: forces follow their contacts. */
TEST(follows_a_grid) {
  const double centers[6] = {20, 0, 0, 21, 0, 0}, radii[2] = {0.6, 0.6};
  const int64_t none[CHAIN_COUNT - 1] = {-1, -1, -1, -1, -1, -1, -1, -1};
  const int32_t gone = 4;
  hg_grid *grid = make_chain(NULL);
  hg_history *history = make_empty_history();
  const hg_pair *pairs;
  const int64_t *previous;
  hg_pair before[CHAIN_COUNT - 1];
  size_t count, k;
  int fresh = 0;
  assert_ok(hg_query_pairs(grid, &pairs, &count));
  assert_int_equal(CHAIN_COUNT - 1, count);
  for (k = 0; k < count; ++k) before[k] = pairs[k];
  assert_update(history, pairs, count, none);
  assert_ok(hg_remove(grid, 1, &gone));
  assert_ok(hg_insert(grid, 2, centers, radii));
  assert_ok(hg_query_pairs(grid, &pairs, &count));
  assert_int_equal(CHAIN_COUNT - 2, count);
  assert_ok(hg_history_update(history, count, pairs, &previous));
  for (k = 0; k < count; ++k) {
    if (previous[k] < 0) {
      ++fresh;
      assert_int_equal(CHAIN_COUNT, pairs[k].a);
    } else {
      assert_int_equal(pairs[k].a, before[previous[k]].a);
      assert_int_equal(pairs[k].b, before[previous[k]].b);
    }
  }
  assert_int_equal(1, fresh);
  hg_history_destroy(history);
  hg_destroy(grid);
}

static hg_status update(hg_history *history, size_t count, const hg_pair *pairs) {
  const int64_t *previous;
  return hg_history_update(history, count, pairs, &previous);
}

TEST(no_memory) { assert_true(refuse_each_allocation_for_many(update) > 3); }

/* Long and short lists by turns. */
static void six_steps(hg_history *history) {
  int step;
  for (step = 0; step < 6; ++step) {
    const int is_long = step % 3 != 0;
    assert_ok(update(history, is_long ? MANY : BEFORE_COUNT, is_long ? many_pairs() : kBefore));
  }
}

/* After the longest lists have been seen, matching asks for no more memory. */
TEST(keeps_its_memory) {
  hg_history *history;
  long long calls;
  failing_alloc_install();
  history = make_history();
  six_steps(history);
  calls = failing_alloc_books().calls;
  six_steps(history);
  assert_int_equal(calls, failing_alloc_books().calls);
  hg_history_destroy(history);
  failing_alloc_remove();
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(finds_places),   cmocka_unit_test(empty_lists),
                                     cmocka_unit_test(its_own_list),   cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(follows_a_grid), cmocka_unit_test(a_pair_twice_is_refused),
                                     cmocka_unit_test(no_memory),      cmocka_unit_test(keeps_its_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
