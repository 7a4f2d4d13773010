/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* What all tests of the C interface start from: cmocka, grids with a known answer, and assertions on statuses, texts
 * and pairs. */
#pragma once

#include "tests/support/frame.h"

#include <hgrid/hgrid.h>

/* Fail with the text of the library if `call` does not give the status. */
#define assert_status(expected, call) fixture_assert_status((expected), (call), #call, __FILE__, __LINE__)
#define assert_ok(call) assert_status(HG_OK, call)
void fixture_assert_status(hg_status expected, hg_status status, const char *call, const char *file, int line);

/* hg_last_error holds the word, in upper or lower case. */
#define assert_error_names(word) fixture_assert_error_names((word), __FILE__, __LINE__)
void fixture_assert_error_names(const char *word, const char *file, int line);

/* The chain: CHAIN_COUNT spheres of radius 0.6 at x = 0, 1, 2 ..., so that each meets the next one only.
 * In 2D and 3D alike the other coordinates are 0. */
enum { CHAIN_COUNT = 9 };
hg_grid *make_chain(const hg_grid_def *def);

/* A grid with these particles; def may be NULL. */
hg_grid *make_grid(const hg_grid_def *def, size_t count, const double *centers, const double *radii);

/* An empty grid. */
hg_grid *make_empty(const hg_grid_def *def);

/* Definitions: levels of these cell sizes; one periodic axis, from 0 to `length`. */
hg_grid_def user_levels(const double *sizes, int32_t count);
hg_grid_def periodic_axis(int axis, double length);

hg_grid_stats stats_of(hg_grid *grid);

/* hg_query_pairs, of which only the status or the number of pairs is of interest. */
hg_status search(hg_grid *grid);
size_t pairs_in(hg_grid *grid);

/* The grid holds exactly these pairs, given in ascending order of (a, b). */
#define assert_pairs(grid, expected, count) fixture_assert_pairs((grid), (expected), (count), __FILE__, __LINE__)
void fixture_assert_pairs(hg_grid *grid, const hg_pair *expected, size_t count, const char *file, int line);

/* The grid holds the pairs (first, first + 1), ... of an untouched chain whose first id is `first`. */
#define assert_chain(grid, first) fixture_assert_chain((grid), (first), __FILE__, __LINE__)
void fixture_assert_chain(hg_grid *grid, int32_t first, const char *file, int line);

/* A visitor that calls `again` on its own grid and keeps the status of that call. */
typedef struct reentry {
  hg_grid *grid;
  hg_status (*again)(hg_grid *grid);
  hg_status status;
  int visits;
} reentry;

/* Visits a chain and expects HG_ERR_STATE from `again` called inside the visitor; the chain is unharmed afterwards. */
void assert_refused_in_visitor(hg_status (*again)(hg_grid *grid));

/* NaN and infinity without the help of the compiler's flags. */
double not_a_number(void);
double infinity(void);
