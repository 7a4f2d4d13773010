// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/ranks/repeated.hpp"

#include "mpi/selection.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ranks {
namespace {

using Offset = std::array<int, 3>;

double edge(const hg_grid_def &def, size_t axis) { return def.box_max[axis] - def.box_min[axis]; }

// Copies along an axis, this one being 0, each once: all there are, or those that anybody may reach.
std::pair<int, int> range_along(const hg_grid_def &def, const hgrid::mpi::ReachRule &rule, double largest, size_t axis,
                                int side) {
  if (axis >= static_cast<size_t>(def.dimension)) return {0, 0};
  const double most = std::ceil(rule.reach(largest, largest) / edge(def, axis)) + 1;
  if (2 * most + 1 < side) return {-static_cast<int>(most), static_cast<int>(most)};
  return {-((side - 1) / 2), side / 2};
}

std::vector<Offset> other_copies(const hg_grid_def &def, const hgrid::mpi::ReachRule &rule, double largest, int side) {
  std::vector<Offset> copies;
  std::pair<int, int> range[3];
  for (size_t axis = 0; axis < 3; axis++) range[axis] = range_along(def, rule, largest, axis, side);
  for (int i = range[0].first; i <= range[0].second; i++) {
    for (int j = range[1].first; j <= range[1].second; j++) {
      for (int k = range[2].first; k <= range[2].second; k++) {
        if (i != 0 || j != 0 || k != 0) copies.push_back({i, j, k});
      }
    }
  }
  return copies;
}

}  // namespace

hg_grid_def cell_of_all(hg_grid_def def, int side) {
  for (size_t axis = 0; axis < static_cast<size_t>(def.dimension); axis++) {
    def.box_max[axis] = def.box_min[axis] + side * edge(def, axis);
  }
  return def;
}

Repeated repeat(const hg_grid_def &def, const Part &copy, int side) {
  const hgrid::mpi::ReachRule rule(cell_of_all(def, side));
  const hgrid::mpi::Selection selection(rule, copy.count(), copy.centers.data(), copy.radii.data());
  const double largest = copy.count() > 0 ? *std::max_element(copy.radii.begin(), copy.radii.end()) : 0;
  const std::vector<Offset> copies = other_copies(def, rule, largest, side);
  hgrid::mpi::BoxesOfRanks boxes{{}, {0}};
  for (const Offset &offset : copies) {
    for (hgrid::mpi::SizeBox box : selection.boxes()) {
      for (size_t axis = 0; axis < 3; axis++) {
        const double shift = axis < static_cast<size_t>(def.dimension) ? offset[axis] * edge(def, axis) : 0;
        box.box.low[axis] += shift;
        box.box.high[axis] += shift;
        box.box.scale += std::fabs(shift);
      }
      boxes.boxes.push_back(box);
    }
    boxes.begin.push_back(boxes.boxes.size());
  }
  Repeated result;
  result.exchange.owned = static_cast<int64_t>(copy.count());
  const std::vector<std::vector<int32_t>> rows = selection.rows_for(boxes, copies.size());
  const auto d = static_cast<size_t>(def.dimension);
  for (size_t k = 0; k < copies.size(); k++) {
    if (rows[k].empty()) continue;
    result.exchange.send_ranks++;
    // What goes to the copy at an offset comes likewise from the one opposite to it.
    for (const int32_t row : rows[k]) {
      for (size_t axis = 0; axis < d; axis++) {
        const double x = copy.centers[static_cast<size_t>(row) * d + axis];
        result.ghosts.centers.push_back(x - copies[k][axis] * edge(def, axis));
      }
      result.ghosts.radii.push_back(copy.radii[static_cast<size_t>(row)]);
    }
  }
  result.exchange.receive_ranks = result.exchange.send_ranks;
  result.exchange.ghosts = result.exchange.sent = static_cast<int64_t>(result.ghosts.count());
  return result;
}

}  // namespace ranks
