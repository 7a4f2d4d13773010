// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Candidates of the oracle along one axis.
#include "tests/support/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hgtest {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Extent {
  double low, high;
  size_t row;
};

// Partners have |dx| < r_i + r_j + margin for either interaction, so their extents, each with half the margin, overlap.
// The two steps outwards make up for the two roundings.
Extent extent_of(const hg_grid_def &def, const Particles &particles, size_t row) {
  const double x = particles.center(row)[0];
  const double half = std::nextafter(particles.radii[row] + 0.5 * def.margin, kInfinity);
  return {std::nextafter(x - half, -kInfinity), std::nextafter(x + half, kInfinity), row};
}

}  // namespace

Pairs swept_pairs(const hg_grid_def &def, const Particles &particles, Interact *interact) {
  std::vector<Extent> extents;
  for (size_t row = 0; row < particles.size(); row++) extents.push_back(extent_of(def, particles, row));
  std::sort(extents.begin(), extents.end(), [](const Extent &a, const Extent &b) { return a.low < b.low; });
  Pairs pairs;
  for (size_t i = 0; i < extents.size(); i++) {
    for (size_t j = i + 1; j < extents.size() && extents[j].low <= extents[i].high; j++) {
      const size_t a = std::min(extents[i].row, extents[j].row), b = std::max(extents[i].row, extents[j].row);
      if (!interact(def, {particles.center(a), particles.radii[a]}, {particles.center(b), particles.radii[b]}))
        continue;
      pairs.push_back({static_cast<int32_t>(a) + def.index_base, static_cast<int32_t>(b) + def.index_base});
    }
  }
  std::sort(pairs.begin(), pairs.end(), pair_less);
  return pairs;
}

}  // namespace hgtest
