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

bool Cell::may_reach(const Box &box, const double *place, double reach) const {
  double scale = reach + box.scale;
  double drift[3] = {0, 0, 0};  // how far edges of later axes may have led a place along this one
  for (int axis = 2; axis >= 0; axis--) {
    if (axis >= dimension_) continue;
    scale += std::fabs(place[axis]);
    if (!periodic_[axis]) continue;
    const double span = std::fabs(box.low[axis] - place[axis]) + (box.high[axis] - box.low[axis]) + reach + drift[axis];
    const double images = 2 + span / length(axis);
    scale += images * scale_[axis];
    for (int along = 0; along < axis; along++) drift[along] += images * std::fabs(edges_[axis][along]);
  }
  return may_reach(box, place, reach + kRounding * scale, 1 + kRounding, dimension_ - 1);
}

// `rest`: what the squares of the gaps along this axis and those before it may sum up to, in squares of the reach.
bool Cell::may_reach(const Box &box, const double *place, double reach, double rest, int axis) const {
  if (axis < 0) return true;
  double first = 0;
  int count = 1;
  if (periodic_[axis]) {
    first = std::ceil((box.low[axis] - reach - place[axis]) / length(axis) - kRounding);
    const double last = std::floor((box.high[axis] + reach - place[axis]) / length(axis) + kRounding);
    if (!(last - first <= kMostImages)) return true;
    count = first <= last ? static_cast<int>(last - first) + 1 : 0;
  }
  for (int k = 0; k < count; k++) {
    const double n = first + k;
    double image[3] = {0, 0, 0};
    std::copy(place, place + dimension_, image);
    if (n != 0) (void)shift(image, axis, n);
    const double gap = std::max(box.low[axis] - image[axis], image[axis] - box.high[axis]);
    double left = rest;
    if (gap > 0) {
      if (gap > reach) continue;
      left -= gap / reach * (gap / reach);
      if (left < 0) continue;
    }
    if (may_reach(box, image, reach, left, axis - 1)) return true;
  }
  return false;
}

}  // namespace hgrid::mpi
