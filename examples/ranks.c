/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* Spheres of two sizes on any number of ranks of MPI: who meets whom, and how many contacts each sphere has. The first
 * rank prints what is the same on any number of ranks. */
#include <hgrid/mpi.h>

#include <stdio.h>
#include <stdlib.h>

enum { EDGE = 16, SPHERES = EDGE * EDGE * EDGE };

static void check(hg_status status) {
  if (status == HG_OK) return;
  fprintf(stderr, "%s: %s\n", hg_status_string(status), hg_last_error());
  MPI_Abort(MPI_COMM_WORLD, 1);
}

int main(int argc, char **argv) {
  static int64_t gids[SPHERES];
  static double centers[SPHERES][3], radii[SPHERES];
  size_t count = 0, ghosts, pair_count, k;
  int rank, ranks, i;
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);

  /* Any rank may bring any spheres: these are dealt out like cards. */
  for (i = rank; i < SPHERES; i += ranks, count++) {
    const int place[3] = {i % EDGE, i / EDGE % EDGE, i / (EDGE * EDGE)};
    gids[count] = i;
    for (k = 0; k < 3; k++) centers[count][k] = place[k];
    radii[count] = i % 100 == 0 ? 2.25 : 0.375;
  }
  hg_mpi *mpi;
  check(hg_mpi_create(MPI_COMM_WORLD, NULL, NULL, &mpi));
  check(hg_mpi_set(mpi, count, gids, centers[0], radii));

  /* New owners, so that the ranks have equal work; without Zoltan the old ones stay. */
  const hg_status balanced = hg_mpi_balance(mpi, NULL, &count);
  if (balanced != HG_ERR_STATE) check(balanced);

  /* Each pair is found by one rank. Its first sphere is owned there, the second may be a ghost. */
  const hg_pair *pairs;
  check(hg_mpi_query_pairs(mpi, &pairs, &pair_count));
  check(hg_mpi_ghosts(mpi, &ghosts, NULL, NULL, NULL, NULL));
  double *contacts = calloc(count + ghosts + 1, sizeof *contacts); /* owned ones, then ghosts */
  if (contacts == NULL) return MPI_Abort(MPI_COMM_WORLD, 1);
  for (k = 0; k < pair_count; k++) {
    contacts[pairs[k].a] += 1;
    contacts[pairs[k].b] += 1;
  }

  /* What ghosts have got goes home. */
  check(hg_mpi_reverse_add(mpi, 1, contacts + count, contacts));

  double here[2] = {(double)pair_count, 0}, most = 0;
  for (k = 0; k < count; k++) here[1] = contacts[k] > here[1] ? contacts[k] : here[1];
  double all = 0;
  MPI_Reduce(&here[0], &all, 1, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
  MPI_Reduce(&here[1], &most, 1, MPI_DOUBLE, MPI_MAX, 0, MPI_COMM_WORLD);
  if (rank == 0) printf("%.0f pairs, a sphere has up to %.0f contacts\n", all, most);
  free(contacts);
  check(hg_mpi_destroy(mpi));
  MPI_Finalize();
  return 0;
}
