/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_last_error, hg_set_last_error: the text of the last failure of the calling thread. */
#include "tests/support/fixture.h"

#include <pthread.h>
#include <string.h>

/* Must run first: nothing has failed yet. */
TEST(empty_before_the_first_failure) {
  assert_non_null(hg_last_error());
  assert_string_equal("", hg_last_error());
}

TEST(kept_by_success_and_replaced_by_failure) {
  hg_grid *grid = make_empty(NULL);
  const double center[3] = {0, 0, 0};
  const double negative = -0.25, one = 1;
  char first[512];
  assert_status(HG_ERR_ARGUMENT, hg_insert(grid, 1, center, &negative));
  assert_error_names("-0.25");
  strncpy(first, hg_last_error(), sizeof first - 1);
  first[sizeof first - 1] = '\0';
  assert_ok(hg_insert(grid, 1, center, &one));
  assert_string_equal(first, hg_last_error());
  assert_status(HG_ERR_NULL, hg_query_pairs(NULL, NULL, NULL));
  assert_string_not_equal(first, hg_last_error());
  assert_true(strlen(hg_last_error()) > 0);
  hg_destroy(grid);
}

static void *fail_in_thread(void *argument) {
  int *good = argument;
  *good = strcmp(hg_last_error(), "") == 0 && hg_create(NULL, NULL) == HG_ERR_NULL && strlen(hg_last_error()) > 0;
  return NULL;
}

TEST(each_thread_has_its_own) {
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid = NULL;
  pthread_t thread;
  int good = 0;
  def.dimension = 7;
  assert_status(HG_ERR_ARGUMENT, hg_create(&def, &grid));
  assert_error_names("7");
  assert_int_equal(0, pthread_create(&thread, NULL, fail_in_thread, &good));
  assert_int_equal(0, pthread_join(thread, NULL));
  assert_true(good);
  assert_error_names("7");
}

TEST(set_by_libraries_on_top) {
  char text[300];
  memset(text, 'x', sizeof text - 1);
  text[sizeof text - 1] = '\0';
  hg_set_last_error("rank 3: no memory");
  assert_string_equal("rank 3: no memory", hg_last_error());
  hg_set_last_error(text);
  assert_int_equal(255, strlen(hg_last_error()));
  hg_set_last_error(NULL);
  assert_string_equal("", hg_last_error());
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(empty_before_the_first_failure), cmocka_unit_test(kept_by_success_and_replaced_by_failure),
      cmocka_unit_test(each_thread_has_its_own), cmocka_unit_test(set_by_libraries_on_top)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
