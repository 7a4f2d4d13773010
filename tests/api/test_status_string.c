/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_status_string: the name of every status. */
#include "tests/support/fixture.h"

TEST(every_status_has_its_name) {
  assert_string_equal("HG_OK", hg_status_string(HG_OK));
  assert_string_equal("HG_ERR_NULL", hg_status_string(HG_ERR_NULL));
  assert_string_equal("HG_ERR_ARGUMENT", hg_status_string(HG_ERR_ARGUMENT));
  assert_string_equal("HG_ERR_MEMORY", hg_status_string(HG_ERR_MEMORY));
  assert_string_equal("HG_ERR_CAPACITY", hg_status_string(HG_ERR_CAPACITY));
  assert_string_equal("HG_ERR_STATE", hg_status_string(HG_ERR_STATE));
  assert_string_equal("HG_ERR_NOT_FOUND", hg_status_string(HG_ERR_NOT_FOUND));
  assert_string_equal("HG_ERR_LIMIT", hg_status_string(HG_ERR_LIMIT));
  assert_string_equal("HG_ERR_INTERNAL", hg_status_string(HG_ERR_INTERNAL));
  assert_string_equal("HG_ERR_MPI", hg_status_string(HG_ERR_MPI));
  assert_string_equal("HG_ERR_REMOTE", hg_status_string(HG_ERR_REMOTE));
}

TEST(other_values_are_unknown) {
  assert_string_equal("unknown status", hg_status_string(-1));
  assert_string_equal("unknown status", hg_status_string(HG_ERR_REMOTE + 1));
  assert_string_equal("unknown status", hg_status_string(INT32_MAX));
  assert_string_equal("unknown status", hg_status_string(INT32_MIN));
}

TEST(values_never_change) {
  assert_int_equal(0, HG_OK);
  assert_int_equal(1, HG_ERR_NULL);
  assert_int_equal(2, HG_ERR_ARGUMENT);
  assert_int_equal(3, HG_ERR_MEMORY);
  assert_int_equal(4, HG_ERR_CAPACITY);
  assert_int_equal(5, HG_ERR_STATE);
  assert_int_equal(6, HG_ERR_NOT_FOUND);
  assert_int_equal(7, HG_ERR_LIMIT);
  assert_int_equal(8, HG_ERR_INTERNAL);
  assert_int_equal(9, HG_ERR_MPI);
  assert_int_equal(10, HG_ERR_REMOTE);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(every_status_has_its_name),
                                     cmocka_unit_test(other_values_are_unknown), cmocka_unit_test(values_never_change)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
