/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* Small grains fall among large ones, in a code as many are: arrays of structs, a Verlet list of pairs that is made
 * anew once a grain has moved by half the skin. Arguments: [COUNT [STEPS]]. Prints where each grain ends, with all
 * digits; on standard error, the seconds that the search and the whole took. */
#include <hgrid/hgrid.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define MAX_GRAINS 200000
#define MAX_PAIRS 8000000

struct grain {
  double x[3], v[3], f[3];
  double radius, mass;
  double x_listed[3]; /* where it was when the list was made */
};

static const double small = 1.0, large = 5.0, skin = 0.8;
static const double stiffness = 2e4, damping = 40.0, gravity = 10.0, dt = 0.002;

static struct grain grain[MAX_GRAINS];
static int grain_count;
static double width; /* of the box; it has no lid */
static int pair_a[MAX_PAIRS], pair_b[MAX_PAIRS], list_count;
static size_t pair_count;
static double search_seconds;

static double seconds(void) {
  struct timespec now;
  timespec_get(&now, TIME_UTC);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void fail(const char *what) {
  fprintf(stderr, "%s\n", what);
  exit(1);
}

static double noise(void) { /* between -0.5 and 0.5, the same everywhere */
  static unsigned state = 1;
  state = state * 1664525u + 1013904223u;
  return (double)(state >> 8) / 16777216.0 - 0.5;
}

/* Fills layers from the height z upwards until there are `until` grains; gives the height above them. */
static double add_layers(int until, double radius, double z) {
  const double step = 2.05 * radius;
  const int row = (int)(width / step);
  int i, k;
  for (i = 0; grain_count < until; i++) {
    struct grain *g = &grain[grain_count++];
    if (i > 0 && i % (row * row) == 0) z += step;
    g->radius = radius;
    g->mass = radius * radius * radius;
    g->x[0] = (i % row + 0.5) * step;
    g->x[1] = (i / row % row + 0.5) * step;
    g->x[2] = z + radius;
    for (k = 0; k < 3; k++) g->x[k] += 0.04 * radius * noise();
    for (k = 0; k < 3; k++) g->v[k] = 4 * noise();
  }
  return z + step;
}

static int is_near(const struct grain *a, const struct grain *b, double margin) {
  const double dx = b->x[0] - a->x[0], dy = b->x[1] - a->x[1], dz = b->x[2] - a->x[2];
  const double reach = a->radius + b->radius + margin;
  return dx * dx + dy * dy + dz * dz < reach * reach;
}

/* Lists the pairs that are nearer to touching than the skin, ascending: forces are then added up in the same order,
 * whatever the cells. */
static void find_pairs(void) {
  static hg_grid *grid;
  hg_grid_def def = hg_default_grid_def();
  hg_array center[3], radius = {&grain->radius, sizeof *grain, HG_REAL64, 0};
  for (int k = 0; k < 3; k++) center[k] = (hg_array){&grain->x[k], sizeof *grain, HG_REAL64, 0};
  def.margin = skin;
  def.pair_order = HG_ORDER_ID;
  if ((grid == NULL && hg_create(&def, &grid)) || hg_set_arrays(grid, grain_count, center, &radius) ||
      hg_copy_pairs(grid, MAX_PAIRS, pair_a, pair_b, &pair_count))
    fail(hg_last_error());
}

static int list_is_old(void) {
  double moved = 0;
  int i;
  for (i = 0; i < grain_count; i++) {
    const double *x = grain[i].x, *was = grain[i].x_listed;
    const double dx = x[0] - was[0], dy = x[1] - was[1], dz = x[2] - was[2];
    moved = fmax(moved, dx * dx + dy * dy + dz * dz);
  }
  return 4 * moved > skin * skin;
}

static void update_list(void) {
  const double start = seconds();
  int i, k;
  if (list_count == 0 || list_is_old()) {
    find_pairs();
    list_count++;
    for (i = 0; i < grain_count; i++)
      for (k = 0; k < 3; k++) grain[i].x_listed[k] = grain[i].x[k];
  }
  search_seconds += seconds() - start;
}

/* Spring and dashpot along the line of centres. */
static void collide(struct grain *a, struct grain *b) {
  double n[3], distance, speed = 0, push;
  int k;
  for (k = 0; k < 3; k++) n[k] = b->x[k] - a->x[k];
  distance = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (k = 0; k < 3; k++) n[k] /= distance;
  for (k = 0; k < 3; k++) speed += n[k] * (b->v[k] - a->v[k]);
  push = stiffness * (a->radius + b->radius - distance) - damping * speed;
  for (k = 0; k < 3; k++) {
    a->f[k] -= push * n[k];
    b->f[k] += push * n[k];
  }
}

/* Floor and sides. */
static void hit_walls(struct grain *g) {
  int k;
  for (k = 0; k < 3; k++) {
    const double low = g->radius - g->x[k], high = g->x[k] + g->radius - width;
    if (low > 0) g->f[k] += stiffness * low - damping * g->v[k];
    if (high > 0 && k < 2) g->f[k] -= stiffness * high + damping * g->v[k];
  }
}

static int step(void) {
  int contacts = 0, i, k;
  size_t p;
  update_list();
  for (i = 0; i < grain_count; i++) {
    grain[i].f[0] = grain[i].f[1] = 0;
    grain[i].f[2] = -gravity * grain[i].mass;
    hit_walls(&grain[i]);
  }
  for (p = 0; p < pair_count; p++)
    if (is_near(&grain[pair_a[p]], &grain[pair_b[p]], 0)) {
      collide(&grain[pair_a[p]], &grain[pair_b[p]]);
      contacts++;
    }
  for (i = 0; i < grain_count; i++)
    for (k = 0; k < 3; k++) {
      grain[i].v[k] += dt / grain[i].mass * grain[i].f[k];
      grain[i].x[k] += dt * grain[i].v[k];
    }
  return contacts;
}

int main(int argc, char **argv) {
  const int count = argc > 1 ? atoi(argv[1]) : 50000, steps = argc > 2 ? atoi(argv[2]) : 200;
  double start;
  int i, s;
  if (count < 100 || count > MAX_GRAINS || steps < 1) fail("arguments: [COUNT [STEPS]]");
  width = fmax(4 * large, 3 * cbrt(count));
  add_layers(count, small, add_layers(count / 125, large, 0));
  start = seconds();
  for (s = 1; s <= steps; s++) {
    const int contacts = step();
    if (s % 20 == 0) printf("step %d: %d contacts, lists made %d\n", s, contacts, list_count);
  }
  fprintf(stderr, "search %.3f s, all %.3f s\n", search_seconds, seconds() - start);
  for (i = 0; i < grain_count; i++) printf("%.17g %.17g %.17g\n", grain[i].x[0], grain[i].x[1], grain[i].x[2]);
  return 0;
}
