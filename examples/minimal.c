/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* The contacts of a large, a middle and a small sphere. */
#include <hgrid/hgrid.h>

#include <stdio.h>

int main(void) {
  const double x[] = {0, 0, 0, 10.5, 0, 0, 11.75, 0, 0};
  const double r[] = {10, 1, 0.5};
  const hg_pair *pairs; /* belong to the grid */
  hg_grid *grid;
  size_t n, k;
  if (hg_create(NULL, &grid) != HG_OK) return 1;
  if (hg_insert(grid, 3, x, r) != HG_OK) return 1;
  if (hg_query_pairs(grid, &pairs, &n) != HG_OK) return 1;
  for (k = 0; k < n; k++) printf("%d meets %d\n", (int)pairs[k].a, (int)pairs[k].b);
  hg_destroy(grid);
  return 0;
}
