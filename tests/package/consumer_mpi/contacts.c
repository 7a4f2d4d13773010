/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* A user's program over ranks: the version of the library and the two contacts among three spheres, by gid. */
#include <hgrid/mpi.h>

#include <stdio.h>

int main(int argc, char **argv) {
  const int64_t gids[] = {0, 1, 2};
  const double centers[] = {0.0, 0.0, 0.0, 1.5, 0.0, 0.0, 3.0, 0.0, 0.0};
  const double radii[] = {1.0, 0.8, 0.9};
  hg_grid_def def = hg_default_grid_def();
  hg_mpi *mpi = NULL;
  const hg_pair *pairs = NULL;
  size_t count = 0;
  int status = 0, major = 0, minor = 0, patch = 0;

  MPI_Init(&argc, &argv);
  def.pair_order = HG_ORDER_ID;
  if (hg_mpi_create(MPI_COMM_WORLD, &def, NULL, &mpi) != HG_OK || hg_mpi_set(mpi, 3, gids, centers, radii) != HG_OK ||
      hg_mpi_query_pairs(mpi, &pairs, &count) != HG_OK) {
    (void)fprintf(stderr, "%s\n", hg_last_error());
    status = 1;
  }
  hg_version(&major, &minor, &patch);
  printf("hgrid %d.%d.%d\n", major, minor, patch);
  for (size_t k = 0; k < count; ++k) {
    printf("%d %d\n", (int)pairs[k].a, (int)pairs[k].b);
  }
  (void)hg_mpi_destroy(mpi);
  MPI_Finalize();
  return status;
}
