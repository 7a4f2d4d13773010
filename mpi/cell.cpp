// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/cell.hpp"

#include <algorithm>
#include <cmath>

namespace hgrid::mpi {
namespace {

// Of the sum of all numbers that go into a distance: some dozen roundings of 2^-53 each.
constexpr double kRounding = 0x1p-46;
// More images than that along an axis are not looked at: the box counts as reached.
constexpr double kMostImages = 8;

}  // namespace

Cell::Cell(const hg_grid_def &def) : dimension_(def.dimension) {
  for (int axis = 0; axis < dimension_; axis++) {
    if (def.periodic[axis] == 0) continue;
    periodic_[axis] = true;
    low_[axis] = def.box_min[axis];
    edges_[axis][axis] = def.box_max[axis] - def.box_min[axis];
    scale_[axis] = std::fabs(def.box_min[axis]) + std::fabs(def.box_max[axis]);
  }
  edges_[1][0] = def.tilt[0];
  edges_[2][0] = def.tilt[1];
  edges_[2][1] = def.tilt[2];
  scale_[1] += std::fabs(def.tilt[0]);
  scale_[2] += std::fabs(def.tilt[1]) + std::fabs(def.tilt[2]);
}

double Cell::shift(double *place, int axis, double n) const {
  for (int along = 0; along <= axis; along++) place[along] += n * edges_[axis][along];
  return std::fabs(n) * scale_[axis];
}

double Cell::distance_moved(const double *from, const double *to) const {
  double step[3] = {0, 0, 0}, scale = 0, squares = 0;
  for (int axis = 0; axis < dimension_; axis++) {
    step[axis] = to[axis] - from[axis];
    scale += std::fabs(step[axis]);
  }
  for (int axis = 2; axis >= 0; axis--) {
    if (periodic_[axis]) scale += shift(step, axis, -std::nearbyint(step[axis] / length(axis)));
    squares += step[axis] * step[axis];
  }
  // Squares so small that they vanish are those of steps below 2^-511.
  return std::sqrt(squares) + kRounding * scale + 0x1p-510 * (squares > 0 || scale > 0 ? 1 : 0);
}

double Cell::slack(const Box &box, const Box &other, double reach) const {
  double scale = reach + box.scale + other.scale;
  double drift[3] = {0, 0, 0};  // how far edges of later axes may have led an image along this one
  for (int axis = dimension_ - 1; axis >= 0; axis--) {
    if (!periodic_[axis]) continue;
    const double span = std::fabs(box.low[axis] - other.low[axis]) + (box.high[axis] - box.low[axis]) +
                        (other.high[axis] - other.low[axis]) + reach + drift[axis];
    const double images = 2 + span / length(axis);
    scale += images * scale_[axis];
    for (int along = 0; along < axis; along++) drift[along] += images * std::fabs(edges_[axis][along]);
  }
  return kRounding * scale;
}

Cell::Range Cell::images_along(int axis, const Box &box, double offset, const Box &other, double reach) const {
  const double low = box.low[axis] + offset, high = box.high[axis] + offset;
  if (!periodic_[axis]) return {0, low - other.high[axis] > reach || other.low[axis] - high > reach ? 0 : 1};
  const double first = std::ceil((other.low[axis] - reach - high) / length(axis) - kRounding);
  const double last = std::floor((other.high[axis] + reach - low) / length(axis) + kRounding);
  if (!(last - first <= kMostImages)) return {0, -1};
  return {first, first <= last ? static_cast<int>(last - first) + 1 : 0};
}

}  // namespace hgrid::mpi
