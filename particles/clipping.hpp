// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Boxes along the axes, and what of flat shapes lies within.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace particles {

using Point = std::array<double, 3>;

struct Bounds {
  Point low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  bool is_empty() const { return !(low[0] <= high[0]); }
  void hold(const Point &point, double radius = 0) {
    for (size_t axis = 0; axis < 3; axis++) {
      low[axis] = std::min(low[axis], point[axis] - radius);
      high[axis] = std::max(high[axis], point[axis] + radius);
    }
  }
  void grow(double way) {
    for (size_t axis = 0; axis < 3; axis++) {
      low[axis] -= way;
      high[axis] += way;
    }
  }
  // Of the longest edge.
  double edge() const { return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}); }
  double diagonal() const { return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]); }
  Point middle() const { return {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2])}; }
  // Of the eight, by bits: 1 for the high end of x, 2 of y, 4 of z.
  Point corner(unsigned bits) const {
    Point result;
    for (size_t axis = 0; axis < 3; axis++) result[axis] = (bits >> axis & 1) != 0 ? high[axis] : low[axis];
    return result;
  }
};

// The part of a convex polygon, or of a segment, if there are two points, that lies within; empty if none does
// (Sutherland & Hodgman, Commun. ACM 17 (1974) 32).
inline std::vector<Point> clipped(std::vector<Point> points, const Bounds &bounds) {
  for (size_t side = 0; side < 6; side++) {
    const size_t axis = side / 2;
    const auto depth = [&](const Point &point) {
      return side % 2 == 0 ? point[axis] - bounds.low[axis] : bounds.high[axis] - point[axis];
    };
    std::vector<Point> kept;
    for (size_t k = 0; k < points.size(); k++) {
      const Point &a = points[k], &b = points[(k + 1) % points.size()];
      const double in = depth(a), next = depth(b);
      if (in >= 0) kept.push_back(a);
      if ((points.size() == 2 && k == 1) || (in < 0) == (next < 0)) continue;
      Point met;
      for (size_t c = 0; c < 3; c++) met[c] = a[c] + in / (in - next) * (b[c] - a[c]);
      kept.push_back(met);
    }
    points = std::move(kept);
  }
  return points;
}

}  // namespace particles
