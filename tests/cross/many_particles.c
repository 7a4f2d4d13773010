/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* A host with more particles than threads are worth waking for: 100 000 on a cubic lattice, each in contact with its
 * neighbours along the axes. With OpenMP of its own, the host uses its threads before and after the library does. */
#include <hgrid/hgrid.h>

#include <stdio.h>
#include <stdlib.h>

enum { SIDE_X = 50, SIDE_Y = 50, SIDE_Z = 40, COUNT = SIDE_X * SIDE_Y * SIDE_Z };
enum { CONTACTS = 3 * COUNT - SIDE_Y * SIDE_Z - SIDE_X * SIDE_Z - SIDE_X * SIDE_Y };

static double sum_of_host(void) {
  double sum = 0;
  int i;
#ifdef _OPENMP
#pragma omp parallel for reduction(+ : sum) num_threads(2)
#endif
  for (i = 0; i < COUNT; ++i) sum += 1;
  return sum;
}

int main(void) {
  double *centers = malloc(3 * COUNT * sizeof *centers), *radii = malloc(COUNT * sizeof *radii);
  int faults = 0, i, threads;
  if (centers == NULL || radii == NULL) return 1;
  for (i = 0; i < COUNT; ++i) {
    centers[3 * i] = i % SIDE_X;
    centers[3 * i + 1] = i / SIDE_X % SIDE_Y;
    centers[3 * i + 2] = i / (SIDE_X * SIDE_Y);
    radii[i] = 0.625;
  }
  for (threads = 1; threads <= 4; ++threads) {
    hg_grid_def def = hg_default_grid_def();
    const hg_pair *pairs;
    hg_grid *grid;
    size_t count = 0;
    def.thread_count = threads;
    faults += sum_of_host() != COUNT;
    if (hg_create(&def, &grid) != HG_OK || hg_insert(grid, COUNT, centers, radii) != HG_OK ||
        hg_query_pairs(grid, &pairs, &count) != HG_OK) {
      (void)fprintf(stderr, "%s\n", hg_last_error());
      return 1;
    }
    if (count != (size_t)CONTACTS) {
      printf("%d threads: %lu contacts instead of %d\n", threads, (unsigned long)count, (int)CONTACTS);
      faults++;
    }
    hg_destroy(grid);
    faults += sum_of_host() != COUNT;
  }
  free(centers);
  free(radii);
  return faults;
}
