// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Mapping phase (Eqs. 1-3) and contact detection phase (Eqs. 4-5) of the paper, scalar and unadorned.
#include "programs/bench/hierarchical_grid.hpp"

#include "programs/bench/half_stencil.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace bench {
namespace {

// Level of insertion, Eq. 3: the finest whose cells are no smaller than the particle.
std::vector<std::vector<int32_t>> members_of_levels(const Particles &particles, const std::vector<double> &cell_sizes) {
  if (!cell_sizes.empty() && !(cell_sizes.front() > 0)) throw std::invalid_argument("a cell size must be positive");
  std::vector<std::vector<int32_t>> members(cell_sizes.size());
  for (size_t i = 0; i < particles.count; i++) {
    const auto level = std::lower_bound(cell_sizes.begin(), cell_sizes.end(), 2 * particles.radii[i]);
    if (level == cell_sizes.end()) {
      throw std::invalid_argument("particle " + std::to_string(i) + " is larger than the cells of the last level");
    }
    members[static_cast<size_t>(level - cell_sizes.begin())].push_back(static_cast<int32_t>(i));
  }
  return members;
}

// Cross-level search of one particle in a finer level: all cells of the box x_p -+ a, a = r_p + s_h / 2 (Eq. 4).
template <int D>
int64_t search_finer(const Sorted<D> &p, const CellArray<D> &level, double cell_size, std::vector<hg_pair> &pairs) {
  const double a = p.r + 0.5 * cell_size;
  typename CellArray<D>::Index low, high;
  for (int k = 0; k < D; k++) {
    low[static_cast<size_t>(k)] = level.cell(k, p.x[k] - a);
    high[static_cast<size_t>(k)] = level.cell(k, p.x[k] + a);
  }
  const Sorted<D> *particles = level.particles().data();
  int64_t tested = 0;
  typename CellArray<D>::Index row = low;
  for (;;) {
    const size_t first_cell = level.cell_number(row);
    const size_t last_cell = first_cell + static_cast<size_t>(high[0] - low[0]);
    const Sorted<D> *first = particles + level.start()[first_cell];
    const Sorted<D> *last = particles + level.start()[last_cell + 1];
    test_range(p, first, last, pairs);
    tested += last - first;
    size_t k = 1;
    while (k < D && row[k] == high[k]) {
      row[k] = low[k];
      k++;
    }
    if (k == D) return tested;
    row[k]++;
  }
}

template <int D>
std::vector<hg_pair> search(const Particles &particles, const std::vector<double> &cell_sizes, int64_t *tested) {
  const std::vector<std::vector<int32_t>> members = members_of_levels(particles, cell_sizes);
  const Bounds<D> bounds = bounds_of<D>(particles);
  std::vector<hg_pair> pairs;
  int64_t candidates = 0;
  std::vector<CellArray<D>> levels;
  std::vector<double> sizes;
  for (size_t h = 0; h < members.size(); h++) {
    if (members[h].empty() || !(cell_sizes[h] > 0))
      continue;  // nothing to find; points overlap nothing but larger ones
    levels.emplace_back(particles, members[h], bounds, cell_sizes[h]);
    sizes.push_back(cell_sizes[h]);
  }
  for (size_t h = 0; h < levels.size(); h++) {
    candidates += half_stencil_pairs(levels[h], pairs);
    for (const Sorted<D> &p : levels[h].particles()) {
      for (size_t k = 0; k < h; k++) candidates += search_finer(p, levels[k], sizes[k], pairs);
    }
  }
  if (tested != nullptr) *tested = candidates;
  return pairs;
}

}  // namespace

std::vector<hg_pair> hierarchical_grid_pairs(int dimension, const Particles &particles,
                                             const std::vector<double> &cell_sizes, int64_t *tested) {
  return dimension == 2 ? search<2>(particles, cell_sizes, tested) : search<3>(particles, cell_sizes, tested);
}

}  // namespace bench
