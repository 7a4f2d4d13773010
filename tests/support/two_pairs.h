/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* Two pairs of spheres that swap partners: what calls that take all particles at once are tried with. */
#pragma once

#include "tests/support/fixture.h"

#include <string.h>

/* (0, 1) and (2, 3) overlap; moved, (0, 2) and (1, 3). */
static const double kStart[12] = {0, 0, 0, 1, 0, 0, 10, 0, 0, 11, 0, 0};
static const double kMoved[12] = {0, 0, 0, 10, 0, 0, 1, 0, 0, 11, 0, 0};
static const double kRadii[4] = {0.6, 0.6, 0.6, 0.6};
static const hg_pair kStartPairs[2] = {{0, 1}, {2, 3}}, kMovedPairs[2] = {{0, 2}, {1, 3}};

/* The first `count` of the moved spheres, with one bad value in this row, on axis 0 to 2 or (3) as the radius: refused
 * with its row and text, and the grid keeps what it had at the start. */
static inline void refuse_value(hg_grid *grid, hg_status (*call)(hg_grid *, size_t, const double *, const double *),
                                size_t count, int row, int axis, double value, const char *text) {
  double centers[12], radii[4];
  char row_text[4] = "[0]";
  memcpy(centers, kMoved, sizeof centers);
  memcpy(radii, kRadii, sizeof radii);
  if (axis == 3) {
    radii[row] = value;
  } else {
    centers[3 * row + axis] = value;
  }
  assert_status(HG_ERR_ARGUMENT, call(grid, count, centers, radii));
  row_text[1] = (char)('0' + row);
  assert_error_names(row_text);
  assert_error_names(text);
  assert_pairs(grid, kStartPairs, 2);
}
