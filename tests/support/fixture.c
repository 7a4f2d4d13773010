/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* Grids with a known answer and assertions for the tests of the C interface. */
#include "tests/support/fixture.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

void fixture_assert_status(hg_status expected, hg_status status, const char *call, const char *file, int line) {
  if (status == expected) return;
  print_error("%s gave %s (%s), expected %s\n", call, hg_status_string(status), hg_last_error(),
              hg_status_string(expected));
  _fail(file, line);
}

static int holds_word(const char *text, const char *word) {
  const size_t length = strlen(word);
  for (; *text != '\0'; ++text) {
    size_t k = 0;
    while (k < length && tolower((unsigned char)text[k]) == tolower((unsigned char)word[k])) ++k;
    if (k == length) return 1;
  }
  return 0;
}

void fixture_assert_error_names(const char *word, const char *file, int line) {
  if (holds_word(hg_last_error(), word)) return;
  print_error("\"%s\" does not name \"%s\"\n", hg_last_error(), word);
  _fail(file, line);
}

hg_grid *make_empty(const hg_grid_def *def) {
  hg_grid *grid = NULL;
  assert_ok(hg_create(def, &grid));
  assert_non_null(grid);
  return grid;
}

hg_grid_def user_levels(const double *sizes, int32_t count) {
  hg_grid_def def = hg_default_grid_def();
  def.level_rule = HG_LEVELS_USER;
  def.level_count = count;
  def.cell_sizes = sizes;
  return def;
}

hg_grid_def periodic_axis(int axis, double length) {
  hg_grid_def def = hg_default_grid_def();
  def.periodic[axis] = 1;
  def.box_max[axis] = length;
  return def;
}

hg_grid_stats stats_of(hg_grid *grid) {
  hg_grid_stats stats;
  assert_ok(hg_get_stats(grid, &stats, sizeof stats));
  return stats;
}

hg_status search(hg_grid *grid) {
  const hg_pair *pairs;
  size_t count;
  return hg_query_pairs(grid, &pairs, &count);
}

size_t pairs_in(hg_grid *grid) {
  const hg_pair *pairs;
  size_t count = 0;
  assert_ok(hg_query_pairs(grid, &pairs, &count));
  return count;
}

hg_grid *make_grid(const hg_grid_def *def, size_t count, const double *centers, const double *radii) {
  hg_grid *grid = make_empty(def);
  assert_ok(hg_insert(grid, count, centers, radii));
  return grid;
}

hg_grid *make_chain(const hg_grid_def *def) {
  const int dimension = def == NULL ? 3 : def->dimension;
  double centers[3 * CHAIN_COUNT] = {0};
  double radii[CHAIN_COUNT];
  int i;
  for (i = 0; i < CHAIN_COUNT; ++i) {
    centers[i * dimension] = i;
    radii[i] = 0.6;
  }
  return make_grid(def, CHAIN_COUNT, centers, radii);
}

static int compare_pairs(const void *left, const void *right) {
  const hg_pair *p = left, *q = right;
  if (p->a != q->a) return p->a < q->a ? -1 : 1;
  return p->b < q->b ? -1 : p->b > q->b;
}

void fixture_assert_pairs(hg_grid *grid, const hg_pair *expected, size_t count, const char *file, int line) {
  const hg_pair *pairs = NULL;
  hg_pair *copy;
  size_t found = 0, k;
  fixture_assert_status(HG_OK, hg_query_pairs(grid, &pairs, &found), "hg_query_pairs", file, line);
  if (found != count) {
    print_error("%lu pairs, expected %lu\n", (unsigned long)found, (unsigned long)count);
    _fail(file, line);
  }
  if (count == 0) return;
  copy = malloc(count * sizeof *copy);
  assert_non_null(copy);
  memcpy(copy, pairs, count * sizeof *copy);
  qsort(copy, count, sizeof *copy, compare_pairs);
  for (k = 0; k < count; ++k) {
    if (copy[k].a == expected[k].a && copy[k].b == expected[k].b) continue;
    print_error("pair %lu is (%d, %d), expected (%d, %d)\n", (unsigned long)k, (int)copy[k].a, (int)copy[k].b,
                (int)expected[k].a, (int)expected[k].b);
    free(copy);
    _fail(file, line);
  }
  free(copy);
}

void fixture_assert_chain(hg_grid *grid, int32_t first, const char *file, int line) {
  hg_pair expected[CHAIN_COUNT - 1];
  int32_t i;
  for (i = 0; i < CHAIN_COUNT - 1; ++i) {
    expected[i].a = first + i;
    expected[i].b = first + i + 1;
  }
  fixture_assert_pairs(grid, expected, CHAIN_COUNT - 1, file, line);
}

static int32_t call_again(void *context, const hg_pair *pairs, size_t count) {
  reentry *r = context;
  (void)pairs;
  (void)count;
  ++r->visits;
  r->status = r->again(r->grid);
  return 0;
}

void assert_refused_in_visitor(hg_status (*again)(hg_grid *grid)) {
  reentry r;
  r.grid = make_chain(NULL);
  r.again = again;
  r.status = HG_OK;
  r.visits = 0;
  assert_ok(hg_visit_pairs(r.grid, call_again, &r));
  assert_true(r.visits > 0);
  assert_status(HG_ERR_STATE, r.status);
  assert_chain(r.grid, 0);
  hg_destroy(r.grid);
}

double not_a_number(void) { return strtod("nan", NULL); }

double infinity(void) { return strtod("inf", NULL); }
