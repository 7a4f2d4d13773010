/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* A user's C program: the version of the library and the two contacts among three spheres. */
#include <hgrid/hgrid.h>

#include <stdio.h>

int main(void) {
  const double centers[] = {0.0, 0.0, 0.0, 1.5, 0.0, 0.0, 3.0, 0.0, 0.0};
  const double radii[] = {1.0, 0.8, 0.9};
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid = NULL;
  const hg_pair *pairs = NULL;
  size_t count = 0;
  int major = 0, minor = 0, patch = 0;

  def.pair_order = HG_ORDER_ID;
  if (hg_create(&def, &grid) != HG_OK || hg_insert(grid, 3, centers, radii) != HG_OK ||
      hg_query_pairs(grid, &pairs, &count) != HG_OK) {
    (void)fprintf(stderr, "%s\n", hg_last_error());
    hg_destroy(grid);
    return 1;
  }
  hg_version(&major, &minor, &patch);
  printf("hgrid %d.%d.%d\n", major, minor, patch);
  for (size_t k = 0; k < count; ++k) {
    printf("%d %d\n", (int)pairs[k].a, (int)pairs[k].b);
  }
  hg_destroy(grid);
  return 0;
}
