// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Comparisons of what a grid returns with what it must.
#include "tests/support/compare.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>

namespace hgtest {
namespace {

std::string first_of(const Pairs &pairs) {
  if (pairs.empty()) return "none";
  return std::to_string(pairs.size()) + ", first (" + std::to_string(pairs[0].a) + ", " + std::to_string(pairs[0].b) +
         ")";
}

}  // namespace

void require(bool condition, const std::string &what) {
  if (!condition) throw Failure(what);
}

void require_same(const char *what, const Pairs &got, const Pairs &expected) {
  if (std::equal(got.begin(), got.end(), expected.begin(), expected.end(), pair_equal)) return;
  const oracle::Difference wrong = oracle::difference(expected, got);
  throw Failure(std::string(what) + ": " + std::to_string(got.size()) + " pairs, expected " +
                std::to_string(expected.size()) + "; missing: " + first_of(wrong.missing) +
                "; too many: " + first_of(wrong.extra));
}

void require_same(const char *what, const std::vector<int32_t> &got, const std::vector<int32_t> &expected) {
  if (got == expected) return;
  const auto at = std::mismatch(got.begin(), got.end(), expected.begin(), expected.end());
  throw Failure(std::string(what) + ": " + std::to_string(got.size()) + " ids, expected " +
                std::to_string(expected.size()) + "; they differ from entry " +
                std::to_string(std::distance(got.begin(), at.first)));
}

Grid make_grid(const hg_grid_def &def, const Particles &particles) {
  Grid grid(def);
  grid.insert(particles.count(), particles.centers.data(), particles.radii.data());
  return grid;
}

Pairs pairs_of(const Grid &grid) {
  const hgrid::View<hg_pair> pairs = grid.query_pairs();
  return Pairs(pairs.begin(), pairs.end());
}

Pairs sorted(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end(), pair_less);
  return pairs;
}

Pairs sorted_pairs_of(const Grid &grid) { return sorted(pairs_of(grid)); }

void require_exact(const std::string &what, const hg_grid_def &def, const Particles &particles) {
  require_same(what.c_str(), sorted_pairs_of(make_grid(def, particles)), all_pairs(def, particles, exact_interact));
}

}  // namespace hgtest
