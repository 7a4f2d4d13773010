// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How many others share a particle's cell, estimated from a sample: whether a table of cells suits a level.
#pragma once

#include "src/particles/participants.hpp"
#include "src/space/cell_table.hpp"
#include "src/space/fixed_point.hpp"

namespace hg {

// Beyond so many a widened table does not pay, and chunks of rows take its place.
inline constexpr double kMostCompanions = 4;

// Radii above `above` and up to `up_to` belong to the level.
struct RadiusRange {
  double above, up_to;
};

// The mean over the `members` of a level, not over its cells. Looks no further where it is certain that it is more than
// `enough`, and returns a number that is.
double estimate_companions(const Participants &particles, const FixedPoint &map, int dimension, const CellTable &cells,
                           const RadiusRange &radii, size_t members, double enough);

}  // namespace hg
