// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether two spheres interact, decided without the library: exactly, or by the expression that HG_DOUBLE promises.
//
// The rule (dimension, interaction, margin, periodic axes) is read from the definition of a grid; nothing else of the
// library is used.
#pragma once

#include <hgrid/types.h>

namespace oracle {

struct Sphere {
  const double *center;
  double radius;
};

using Rule = bool(const hg_grid_def &, const Sphere &, const Sphere &);

// In real arithmetic on the stored doubles: in rational numbers, doubles only spare them the clear cases.
bool exact_interact(const hg_grid_def &def, const Sphere &a, const Sphere &b);

// By the plain expression in doubles.
bool double_interact(const hg_grid_def &def, const Sphere &a, const Sphere &b);

// How far a and b are from touching: distance / reach - 1, from exact squares. Needs reach > 0.
double relative_gap(const hg_grid_def &def, const Sphere &a, const Sphere &b);

}  // namespace oracle
