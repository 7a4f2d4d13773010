/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* The contacts of a large, a middle and two small spheres. */
#include <hgrid/hgrid.h>

#include <stdio.h>

int main(void) {
  const double centers[] = {0, 0, 0, /**/ 10.5, 0, 0, /**/ 11.75, 0, 0, /**/ 0, 20, 0};
  const double radii[] = {10, 1, 0.5, 0.1};
  hg_grid_def def = hg_default_grid_def();
  const hg_pair *pairs; /* belong to the grid */
  hg_grid *grid;
  size_t count, i;
  def.pair_order = HG_ORDER_ID;
  if (hg_create(&def, &grid) != HG_OK || hg_insert(grid, 4, centers, radii) != HG_OK ||
      hg_query_pairs(grid, &pairs, &count) != HG_OK) {
    fprintf(stderr, "%s\n", hg_last_error());
    return 1;
  }
  for (i = 0; i < count; i++) printf("%d and %d overlap\n", (int)pairs[i].a, (int)pairs[i].b);
  hg_destroy(grid);
  return 0;
}
