// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Appendix A of Ogarko & Luding (2012) written down literally: particle by particle, every candidate m.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hgtest {

struct LiteralLevel {
  size_t count;
  double cell_size;
};

// The paper's question, for sorted radii: how many particles share a cell of edge s if `count` fill S^d.
struct LiteralVolume {
  int dimension;
  double edge;  // S
  double occupancy(size_t count, double s) const {
    double cells = s / edge;
    for (int axis = 1; axis < dimension; axis++) cells *= s / edge;
    return static_cast<double>(count) * cells;
  }
};

inline std::vector<LiteralLevel> literal_levels(const std::vector<double> &r, const LiteralVolume &volume, double m) {
  std::vector<LiteralLevel> levels;
  for (size_t a = 0; a < r.size();) {
    size_t e = a;
    while (e < r.size() && !(volume.occupancy(e - a + 1, 2 * r[e]) > m)) e++;
    if (e < r.size()) {
      while (e > 0 && r[e - 1] == r[e]) e--;  // equal radii are never split
    }
    if (e <= a) {
      e = a + 1;
      while (e < r.size() && r[e] == r[a]) e++;  // a level is never empty
    }
    levels.push_back({e - a, 2 * r[e - 1]});
    a = e;
  }
  return levels;
}

struct LiteralCost {
  bool reachable;
  double occupancy;  // the largest of the levels
  std::vector<LiteralLevel> levels;
};

// Every value that m can usefully take: that of some run of particles, or 0.
inline std::vector<double> all_occupancies(const std::vector<double> &r, const LiteralVolume &volume) {
  std::vector<double> values = {0};
  for (size_t a = 0; a < r.size(); a++) {
    for (size_t e = a; e < r.size(); e++) values.push_back(volume.occupancy(e - a + 1, 2 * r[e]));
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

// The assignment at m(L), the least m that needs at most L levels, for L = 1 .. most.
inline std::vector<LiteralCost> literal_costs(const std::vector<double> &r, const LiteralVolume &volume, size_t most) {
  const std::vector<double> values = all_occupancies(r, volume);
  std::vector<LiteralCost> costs;
  for (size_t L = 1; L <= most; L++) {
    LiteralCost cost{false, 0, {}};
    for (double m : values) {
      cost.levels = literal_levels(r, volume, m);
      if (cost.levels.size() <= L) break;
    }
    cost.reachable = cost.levels.size() == L;
    for (const LiteralLevel &level : cost.levels) {
      cost.occupancy = std::max(cost.occupancy, volume.occupancy(level.count, level.cell_size));
    }
    costs.push_back(cost);
  }
  return costs;
}

}  // namespace hgtest
