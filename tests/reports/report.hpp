// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Public reports of pairs that other codes lost, doubled or made up, as systems to be searched in every setting.
//
// docs/evidence/reports.md names each report and the function here that rebuilds it.
#pragma once

#include "tests/support/compare.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace hgtest {

using Point = std::array<double, 3>;

// Spheres, or points that meet within a cut-off: then they are searched as equal spheres, as ranges, as points with a
// margin, and as spheres of several sizes, of which the largest have the cut-off for their diameter.
struct System {
  std::string name;
  std::vector<Point> centers;
  double cutoff = 0;                        // of points
  std::vector<double> radii;                // of spheres, else empty
  hg_grid_def def = hg_default_grid_def();  // dimension, box, interaction, margin
  std::optional<size_t> pairs;              // as the report says, or as counted in another way
};

// The same particles in steps, followed by one grid: each step moves all, gives them new radii, perhaps another box.
struct Life {
  std::string name;
  std::vector<Particles> steps;
  hg_grid_def def = hg_default_grid_def();
  std::vector<hg_grid_def> boxes;  // the box and the tilt of each step; empty: those of def in all of them
  std::vector<size_t> pairs;       // after each step, as the report says; empty: by the oracle alone
};

// Searches it with each rule of levels, on one thread and on several, with and without a skin, in each accuracy, and
// compares with exact arithmetic; throws a text that says what differs. System: also rows and spheres.
void check(const System &system);
void check(const Life &life);

// A test of all that a report is rebuilt as.
template <auto rebuild>
void report(void **) {
  assert_true(holds(0, [](uint64_t) {
    for (const auto &each : rebuild()) check(each);
  }));
}

}  // namespace hgtest
