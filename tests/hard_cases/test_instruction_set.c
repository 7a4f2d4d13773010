/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* HGRID_ISA with a name that no build knows: an error that names it, not another instruction set. It is read at the
 * first search, so this program has no other test. */
#define _POSIX_C_SOURCE 200112L
#include "tests/support/fixture.h"

#include <stdlib.h>

TEST(unknown_name_is_refused) {
  const double centers[6] = {0, 0, 0, 1, 0, 0}, radii[2] = {1, 1};
  hg_grid *grid = make_empty(NULL);
  hg_status status;
  assert_int_equal(0, setenv("HGRID_ISA", "abacus", 1));
  status = hg_insert(grid, 2, centers, radii);
  if (status == HG_OK) status = search(grid);
  assert_status(HG_ERR_ARGUMENT, status);
  assert_error_names("abacus");
  assert_int_equal(0, setenv("HGRID_ISA", "scalar", 1));
  assert_ok(hg_clear(grid));
  assert_ok(hg_insert(grid, 2, centers, radii));
  assert_int_equal(1, pairs_in(grid));
  hg_destroy(grid);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(unknown_name_is_refused)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
