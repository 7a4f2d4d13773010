// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether two spheres interact, decided without the library: exactly, or by the expression that HG_DOUBLE promises.
//
// The rule (dimension, interaction, margin, touching, images, periodic axes, tilt) is read from the definition of a
// grid; nothing else of the library is used.
#pragma once

#include <hgrid/types.h>

#include <cstdint>
#include <vector>

namespace oracle {

struct Sphere {
  const double *center;
  double radius;
};

// Whole edges of the periodic cell: the image of b is at x_b + n[0] a + n[1] b + n[2] c.
struct Shift {
  int64_t n[3];
};

// How many images of b interact with a: 0 or 1 with HG_NEAREST_IMAGE. Of a sphere and itself: itself and all its
// images, those at a shift and those at the opposite one.
using Rule = int(const hg_grid_def &def, const Sphere &a, const Sphere &b);

// In real arithmetic on the stored doubles: in rational numbers, doubles only spare them the clear cases.
int exact_interact(const hg_grid_def &def, const Sphere &a, const Sphere &b);

// By the plain expression in doubles.
int double_interact(const hg_grid_def &def, const Sphere &a, const Sphere &b);

// The shifts of b that exact_interact counts, ascending.
std::vector<Shift> exact_shifts(const hg_grid_def &def, const Sphere &a, const Sphere &b);

// How far a and the image of b that is the nearest but `nearer` are from touching: distance / reach - 1, from exact
// squares. Needs reach > 0.
double relative_gap(const hg_grid_def &def, const Sphere &a, const Sphere &b, size_t nearer = 0);

}  // namespace oracle
