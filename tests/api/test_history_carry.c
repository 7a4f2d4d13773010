/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_history_carry: items of any size go where their contacts went. */
#include "tests/support/history_fixture.h"

#include <string.h>

/* Item k holds the bytes 16 k + 1, 16 k + 2 ...; the bytes behind the last item must stay as they are. */
TEST(items_of_any_size) {
  hg_history *history = make_history();
  size_t size;
  for (size = 1; size <= 40; ++size) {
    const int from[AFTER_COUNT] = {2, -1, 0, -1, -1};
    unsigned char before[BEFORE_COUNT * 40], after[AFTER_COUNT * 40 + 1];
    size_t k, byte;
    for (k = 0; k < BEFORE_COUNT; ++k) {
      for (byte = 0; byte < size; ++byte) before[k * size + byte] = (unsigned char)(48 * k + byte + 1);
    }
    memset(after, 0xee, sizeof after);
    assert_ok(hg_history_carry(history, size, before, after));
    for (k = 0; k < AFTER_COUNT; ++k) {
      for (byte = 0; byte < size; ++byte) {
        const int expected = from[k] < 0 ? 0 : 48 * from[k] + (int)byte + 1;
        assert_int_equal((unsigned char)expected, after[k * size + byte]);
      }
    }
    assert_int_equal(0xee, after[AFTER_COUNT * size]);
  }
  hg_history_destroy(history);
}

TEST(empty_lists_need_no_arrays) {
  hg_history *history = make_empty_history();
  const int64_t none[BEFORE_COUNT] = {-1, -1, -1, -1};
  double items[BEFORE_COUNT] = {5, 5, 5, 5};
  const double zeros[BEFORE_COUNT] = {0, 0, 0, 0};
  assert_update(history, kBefore, BEFORE_COUNT, none);
  assert_ok(hg_history_carry(history, sizeof items[0], NULL, items));
  assert_memory_equal(zeros, items, sizeof items);
  assert_update(history, NULL, 0, NULL);
  assert_ok(hg_history_carry(history, sizeof items[0], items, NULL));
  hg_history_destroy(history);
}

TEST(wrong_arguments) {
  hg_history *history = make_history();
  double items[BEFORE_COUNT + AFTER_COUNT] = {0};
  assert_status(HG_ERR_NULL, hg_history_carry(NULL, 8, items, items + BEFORE_COUNT));
  assert_status(HG_ERR_NULL, hg_history_carry(history, 8, NULL, items));
  assert_error_names("old_items");
  assert_status(HG_ERR_NULL, hg_history_carry(history, 8, items, NULL));
  assert_error_names("new_items");
  assert_status(HG_ERR_ARGUMENT, hg_history_carry(history, 0, items, items + BEFORE_COUNT));
  assert_error_names("item_size");
  assert_ok(hg_history_carry(history, 8, items, items + BEFORE_COUNT));
  assert_ok(hg_history_carry(history, 8, items + AFTER_COUNT, items));
  assert_status(HG_ERR_ARGUMENT, hg_history_carry(history, 8, items, items + BEFORE_COUNT - 1));
  assert_status(HG_ERR_ARGUMENT, hg_history_carry(history, 8, items + AFTER_COUNT - 1, items));
  assert_error_names("overlap");
  hg_history_destroy(history);
}

/* What a failed update leaves is checked in test_history_update.c. */
TEST(nothing_to_carry) {
  hg_history *history = make_history();
  double before[AFTER_COUNT] = {0}, after[BEFORE_COUNT] = {7, 7, 7, 7};
  assert_ok(hg_history_restore(history, BEFORE_COUNT, kBefore));
  assert_status(HG_ERR_STATE, hg_history_carry(history, 8, before, after));
  assert_int_equal(7, (int)after[0]);
  hg_history_destroy(history);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(items_of_any_size), cmocka_unit_test(empty_lists_need_no_arrays),
                                     cmocka_unit_test(wrong_arguments), cmocka_unit_test(nothing_to_carry)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
