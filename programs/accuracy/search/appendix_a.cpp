// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Appendix A with the readings that reproduce the paper's figures: a level ends before the particle that would exceed
// m, and its cells are as large as its largest particle.
#include "programs/accuracy/search/appendix_a.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace accuracy {
namespace {

constexpr size_t kMostLevels = 64;  // HG_MAX_LEVELS: the library takes no more

// Share of the cube that a cell of particle i takes.
double cell_share(const Sizes &sizes, size_t i) {
  const double side = 2 * sizes.radii[i] / sizes.edge;
  return sizes.dimension == 2 ? side * side : side * side * side;
}

double occupancy(const Sizes &sizes, size_t begin, size_t end) {
  return sizes.weight * static_cast<double>(end - begin) * cell_share(sizes, end - 1);
}

// First row that would bring the level over m; the number per cell grows with each particle and each radius.
size_t end_of_level(const Sizes &sizes, size_t begin, double m) {
  size_t low = begin, high = sizes.radii.size();
  while (low < high) {
    const size_t middle = low + (high - low) / 2;
    if (occupancy(sizes, begin, middle + 1) > m) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  const auto first = sizes.radii.begin(), last = sizes.radii.end();
  size_t end = low;
  if (end < sizes.radii.size()) {
    end = static_cast<size_t>(std::lower_bound(first, last, sizes.radii[end]) - first);
  }
  if (end <= begin) end = static_cast<size_t>(std::upper_bound(first, last, sizes.radii[begin]) - first);
  return end;
}

Choice choice_of(const Sizes &sizes, double m, size_t most, double overhead) {
  Choice choice;
  choice.ends = levels_for(sizes, m, most);
  choice.cost = static_cast<double>(choice.ends.size()) * (occupancy_of(sizes, choice.ends) + overhead);
  return choice;
}

}  // namespace

LevelEnds levels_for(const Sizes &sizes, double m, size_t most) {
  LevelEnds ends;
  for (size_t begin = 0; begin < sizes.radii.size() && ends.size() <= most; begin = ends.back()) {
    ends.push_back(end_of_level(sizes, begin, m));
  }
  return ends;
}

double occupancy_of(const Sizes &sizes, const LevelEnds &ends) {
  double largest = 0;
  size_t begin = 0;
  for (const size_t end : ends) {
    largest = std::max(largest, occupancy(sizes, begin, end));
    begin = end;
  }
  return largest;
}

double least_m(const Sizes &sizes, size_t most) {
  double low = 0, high = occupancy(sizes, 0, sizes.radii.size());
  constexpr int kHalvings = 60;  // leaves 1e-18 of the first interval
  for (int k = 0; k < kHalvings; k++) {
    const double middle = 0.5 * (low + high);
    (levels_for(sizes, middle, most).size() <= most ? high : low) = middle;
  }
  return high;
}

Choice cheapest_by_bisection(const Sizes &sizes, double overhead) {
  Choice best = choice_of(sizes, least_m(sizes, 1), 1, overhead);
  // No L is cheaper than L K.
  for (size_t most = 2; most <= kMostLevels && static_cast<double>(most) * overhead < best.cost; most++) {
    Choice choice = choice_of(sizes, least_m(sizes, most), most, overhead);
    if (choice.cost < best.cost) best = std::move(choice);
  }
  return best;
}

Choice cheapest_on_grid(const Sizes &sizes, double overhead, double step) {
  Choice best;
  size_t fewest = kMostLevels + 1;  // the first m of the grid with so many levels is the least
  for (int64_t j = 1; fewest > 1; j++) {
    const double m = static_cast<double>(j) * step;
    // m - step was not enough for as few levels as m gives, so these hold more than m - step, and cost at least:
    if (!best.ends.empty() && m - step + overhead > best.cost) break;
    Choice choice = choice_of(sizes, m, kMostLevels, overhead);
    if (choice.ends.size() >= fewest) continue;
    fewest = choice.ends.size();
    if (best.ends.empty() || choice.cost <= best.cost) best = std::move(choice);
  }
  return best;
}

double cost_of_edges(const Sizes &sizes, const std::vector<double> &edges, double overhead) {
  LevelEnds ends;
  const auto first = sizes.radii.begin(), last = sizes.radii.end();
  for (size_t level = 0; level < edges.size(); level++) {
    const bool whole = level + 1 == edges.size();
    const auto end = static_cast<size_t>((whole ? last : std::upper_bound(first, last, edges[level])) - first);
    if (end > (ends.empty() ? 0 : ends.back())) ends.push_back(end);
  }
  return static_cast<double>(ends.size()) * (occupancy_of(sizes, ends) + overhead);
}

std::vector<double> edges_of(const Sizes &sizes, const LevelEnds &ends) {
  std::vector<double> edges;
  for (const size_t end : ends) edges.push_back(sizes.radii[end - 1]);
  return edges;
}

}  // namespace accuracy
