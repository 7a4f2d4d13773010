/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* A library that was built amid -ffast-math still knows NaN and infinity, and leaves the arithmetic of its host alone:
 * subnormal numbers are no zeros. */
#include <hgrid/hgrid.h>

#include <math.h>
#include <stdio.h>

int main(void) {
  const double bad[] = {NAN, INFINITY, -INFINITY};
  const double origin[3] = {0, 0, 0};
  volatile double least_normal = 2.2250738585072014e-308;
  hg_grid *grid = NULL;
  int faults = 0;
  size_t k;

  if (hg_create(NULL, &grid) != HG_OK) return 1;
  for (k = 0; k < sizeof bad / sizeof *bad; ++k) {
    const double radius = 1, center[3] = {0, bad[k], 0};
    if (hg_insert(grid, 1, center, &radius) != HG_ERR_ARGUMENT ||
        hg_insert(grid, 1, origin, &bad[k]) != HG_ERR_ARGUMENT) {
      printf("%g was taken for a number\n", bad[k]);
      faults++;
    }
  }
  hg_destroy(grid);
  if (least_normal / 4 == 0) {
    printf("subnormal numbers are flushed to zero\n");
    faults++;
  }
  return faults;
}
