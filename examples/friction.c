/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* A loop over time steps, with a skin, and with data of contacts that follow them: how many steps each contact has
 * lasted. A friction law would keep the length of its spring in the same way. */
#include <hgrid/hgrid.h>

#include <stdio.h>
#include <stdlib.h>

enum { SPHERES = 40, STEPS = 6 };

int main(void) {
  double centers[3 * SPHERES] = {0}, radii[SPHERES];
  double *age = NULL; /* one for each pair of the last list */
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  hg_grid_stats stats;
  hg_history *history;
  int step, i;
  for (i = 0; i < SPHERES; i++) {
    centers[3 * i] = i;
    radii[i] = 0.51;
  }
  def.skin = 0.4; /* five times what a sphere moves in a step */
  if (hg_create(&def, &grid) != HG_OK || hg_insert(grid, SPHERES, centers, radii) != HG_OK ||
      hg_history_create(&history) != HG_OK) {
    fprintf(stderr, "%s\n", hg_last_error());
    return 1;
  }
  for (step = 1; step <= STEPS; step++) {
    const hg_pair *pairs;
    const int64_t *previous;
    double *now, oldest = 0;
    size_t count, k, fresh = 0;
    if (hg_query_pairs(grid, &pairs, &count) != HG_OK || hg_history_update(history, count, pairs, &previous) != HG_OK ||
        (now = malloc((count + 1) * sizeof *now)) == NULL ||
        hg_history_carry(history, sizeof *now, age, now) != HG_OK) {
      fprintf(stderr, "%s\n", hg_last_error());
      return 1;
    }
    free(age);
    age = now;
    for (k = 0; k < count; k++) {
      age[k] += 1;
      if (age[k] > oldest) oldest = age[k];
      if (previous[k] < 0) fresh++;
    }
    printf("step %d: %d contacts, %d new, the oldest lasts %.0f steps\n", step, (int)count, (int)fresh, oldest);
    for (i = 0; i < SPHERES; i += 4)
      centers[3 * i + 1] += step < 4 ? 0.08 : -0.08; /* every fourth goes up, comes back */
    if (hg_move(grid, SPHERES, centers, NULL) != HG_OK) return 1;
  }
  if (hg_get_stats(grid, &stats, sizeof stats) != HG_OK) return 1;
  printf("searched %d times, filtered %d times\n", (int)stats.search_count, (int)stats.filter_count);
  free(age);
  hg_history_destroy(history);
  hg_destroy(grid);
  return 0;
}
