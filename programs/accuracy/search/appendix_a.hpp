// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The choice of levels in Appendix A of Ogarko & Luding, CPC 183 (2012) 931: assignment of radii to levels for a given
// number m of particles per cell, and the search for the m, by bisection or on a grid of values, whose cost
// f = L (m + K) is least. Independent of the library, to be compared with it.
#pragma once

#include <cstddef>
#include <vector>

namespace accuracy {

constexpr double kPaperOverhead = 0.3;  // K: cost of visiting a cell over that of testing a particle

// Radii, ascending, in a cube (square) of edge S. Each stands for `weight` particles: more than one in a sample.
struct Sizes {
  std::vector<double> radii;
  double edge = 1;
  int dimension = 3;
  double weight = 1;
};

// One level from the last of the level before: it ends before the radius of row `end`.
using LevelEnds = std::vector<size_t>;

// The fewest levels with no more than m particles per cell, equal radii together and no level empty; stops at
// `most` + 1 levels. O(L log N).
LevelEnds levels_for(const Sizes &sizes, double m, size_t most);

// The largest number of particles per cell among the levels.
double occupancy_of(const Sizes &sizes, const LevelEnds &ends);

// The least m with which no more than `most` levels are needed, to the last bit or nearly.
double least_m(const Sizes &sizes, size_t most);

struct Choice {
  LevelEnds ends;
  double cost = 0;  // f
};

// The cheapest L, the fewest levels among equals. By bisection for each L, which is exact.
Choice cheapest_by_bisection(const Sizes &sizes, double overhead);

// By trying m = step, 2 step, ... as the paper does.
Choice cheapest_on_grid(const Sizes &sizes, double overhead, double step);

// f of all `sizes` in cells that were chosen for a sample of them: `edges` are the largest radii of the sample's
// levels. The last level takes all that are larger than its own.
double cost_of_edges(const Sizes &sizes, const std::vector<double> &edges, double overhead);

// The largest radius on each level.
std::vector<double> edges_of(const Sizes &sizes, const LevelEnds &ends);

}  // namespace accuracy
