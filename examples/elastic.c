/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* A gas of elastic spheres in a box: the steps of elastic_steps.c, and what they cost. */
#include "examples/elastic_steps.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { EDGE = 20, COUNT = EDGE * EDGE * EDGE, STEPS = 2000 };

static double kinetic_energy(const spheres *s) {
  double sum = 0;
  size_t k;
  for (k = 0; k < 3 * s->count; k++) sum += 0.5 * s->v[k] * s->v[k] / s->inverse_mass[k / 3];
  return sum;
}

static int fail(void) {
  fprintf(stderr, "%s\n", hg_last_error());
  return 1;
}

int main(void) {
  static double x[3 * COUNT], v[3 * COUNT], f[3 * COUNT], radius[COUNT], inverse_mass[COUNT];
  const double spacing = 1.1; /* in diameters */
  spheres s = {COUNT, x, v, f, radius, inverse_mass, {0, 0, 0}, {0, 0, 0}, 1e4, 1e-4, NULL};
  hg_grid_def def = hg_default_grid_def();
  double before;
  clock_t start;
  int i, step, axis;
  for (axis = 0; axis < 3; axis++) s.high[axis] = EDGE * spacing;
  for (i = 0; i < COUNT; i++) {
    const int place[3] = {i % EDGE, i / EDGE % EDGE, i / (EDGE * EDGE)};
    for (axis = 0; axis < 3; axis++) {
      x[3 * i + axis] = (place[axis] + 0.5) * spacing;
      v[3 * i + axis] = 2.0 * rand() / RAND_MAX - 1;
    }
    radius[i] = 0.5;
    inverse_mass[i] = 1;
  }
  def.thread_count = 1;
  def.skin = 0.1;
  if (hg_create(&def, &s.grid) != HG_OK || hg_insert(s.grid, COUNT, x, radius) != HG_OK) return fail();
  before = kinetic_energy(&s);
  start = clock();
  for (step = 0; step < STEPS; step++)
    if (one_step(&s) != HG_OK) return fail();
  fprintf(stderr, "%.1f ns per sphere and step\n", 1e9 * (double)(clock() - start) / CLOCKS_PER_SEC / STEPS / COUNT);
  /* What is missing is in the springs of contacts. */
  printf("kinetic energy: %.0f %% of that at the start\n", 100 * kinetic_energy(&s) / before);
  hg_destroy(s.grid);
  return 0;
}
