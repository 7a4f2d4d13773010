/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause
 * One search among very many particles, with its time and the peak memory of the process. Radii by the inverse
 * distribution function of the law, places at random, density 0.62, nothing relaxed. */
#include <hgrid/hgrid.h>

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

static double uniform(uint64_t *state) {
  uint64_t z = (*state += 0x9e3779b97f4a7c15u); /* splitmix64 */
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return (double)((z ^ z >> 31) >> 11) / 9007199254740992.0;
}

/* The radius at u in [0, 1), 0 for an unknown law. */
static double radius_of(const char *law, double ratio, double u) {
  if (strcmp(law, "mono") == 0) return 1;
  if (strcmp(law, "two-sizes") == 0) return u * (1 + ratio * ratio * ratio) < 1 ? ratio : 1;
  if (strcmp(law, "uniform-size") == 0) return 1 + (ratio - 1) * u;
  if (strcmp(law, "uniform-volume") == 0) return 1 / sqrt(1 - u * (1 - 1 / (ratio * ratio)));
  return 0;
}

/* Returns the edge of the box. */
static double make_particles(const char *law, double ratio, size_t count, double *centers, double *radii) {
  uint64_t state = 1;
  double volume = 0, edge;
  size_t i, k;
  for (i = 0; i < count; ++i) {
    radii[i] = radius_of(law, ratio, uniform(&state));
    volume += 4.18879020478639 * radii[i] * radii[i] * radii[i];
  }
  edge = cbrt(volume / 0.62);
  for (i = 0; i < count; ++i) {
    for (k = 0; k < 3; ++k) centers[3 * i + k] = edge * uniform(&state);
  }
  return edge;
}

static double now(void) {
  struct timespec t;
  timespec_get(&t, TIME_UTC);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void check(hg_status status) {
  if (status == HG_OK) return;
  fprintf(stderr, "hgrid_scale: %s\n", hg_last_error());
  exit(1);
}

int main(int argc, char **argv) {
  const char *law = argc > 1 ? argv[1] : "";
  const double ratio = argc > 2 ? atof(argv[2]) : 0;
  const size_t count = argc > 3 ? (size_t)strtoull(argv[3], NULL, 10) : 0;
  hg_grid_def def = hg_default_grid_def();
  const hg_pair *pairs;
  struct rusage usage;
  hg_grid_stats stats;
  size_t pair_count;
  double *centers, *radii, edge, start, seconds;
  hg_grid *grid;
  if (count == 0 || !(ratio >= 1) || radius_of(law, ratio, 0) == 0) {
    fprintf(stderr, "usage: hgrid_scale mono|two-sizes|uniform-size|uniform-volume RATIO COUNT [THREADS (1)]\n");
    return 2;
  }
  centers = malloc(3 * count * sizeof *centers);
  radii = malloc(count * sizeof *radii);
  if (centers == NULL || radii == NULL) {
    fprintf(stderr, "hgrid_scale: no memory for %zu particles\n", count);
    return 1;
  }
  edge = make_particles(law, ratio, count, centers, radii);
  printf("%s, ratio %g: %zu particles in a box of edge %g\n", law, ratio, count, edge);
  fflush(stdout);

  def.thread_count = argc > 4 ? atoi(argv[4]) : 1;
  start = now();
  check(hg_create(&def, &grid));
  check(hg_insert(grid, count, centers, radii));
  check(hg_query_pairs(grid, &pairs, &pair_count));
  seconds = now() - start;
  check(hg_get_stats(grid, &stats, sizeof stats));
  getrusage(RUSAGE_SELF, &usage);
  printf("%zu pairs on %d levels in %.1f s, %.0f ns per particle\n", pair_count, (int)stats.level_count, seconds,
         1e9 * seconds / (double)count);
  printf("peak memory of the process %.2f GiB, 32 bytes per particle of it the input\n",
         (double)usage.ru_maxrss / 1048576.0);
  hg_destroy(grid);
  free(centers);
  free(radii);
  return 0;
}
