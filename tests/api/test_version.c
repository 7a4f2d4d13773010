/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_version: the version of the loaded library. */
#include "tests/support/fixture.h"

TEST(equals_that_of_the_header) {
  int major = -1, minor = -1, patch = -1;
  hg_version(&major, &minor, &patch);
  assert_int_equal(HG_VERSION_MAJOR, major);
  assert_int_equal(HG_VERSION_MINOR, minor);
  assert_int_equal(HG_VERSION_PATCH, patch);
}

TEST(each_pointer_may_be_null) {
  int major = -1, minor = -1, patch = -1;
  hg_version(NULL, NULL, NULL);
  hg_version(&major, NULL, NULL);
  hg_version(NULL, &minor, NULL);
  hg_version(NULL, NULL, &patch);
  assert_int_equal(HG_VERSION_MAJOR, major);
  assert_int_equal(HG_VERSION_MINOR, minor);
  assert_int_equal(HG_VERSION_PATCH, patch);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(equals_that_of_the_header),
                                     cmocka_unit_test(each_pointer_may_be_null)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
