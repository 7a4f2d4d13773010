// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Spaces of any size and place with their map to quanta, and centres in them.
#pragma once

#include "src/base/interval.hpp"
#include "src/space/fixed_point.hpp"
#include "tests/support/rng.hpp"
#include "tests/unit/cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace hgtest {

class Space {
 public:
  // Ordinary lengths mostly, else from subnormal numbers to near the greatest; at the origin, or far from it at a power
  // of two, where numbers below the space are finer than those in it. Some are tilted, by up to two lengths.
  explicit Space(Rng &rng) : domain(open_space(rng.integer(2, 3))) {
    const double unit = std::ldexp(1.0, rng.chance(0.7) ? rng.integer(-30, 30) : rng.integer(-1074, 990));
    const double far = rng.chance(0.5) ? 0 : std::ldexp(rng.chance(0.5) ? unit : -unit, rng.integer(0, 30));
    const double periodic = rng.chance(0.3) ? 0.9 : 0.4;
    for (int axis = 0; axis < domain.dimension; axis++) {
      const double low = far, high = far + unit * (rng.chance(0.2) ? 1 : rng.uniform(1, 2));
      set_box(domain, axis, low, high, high > low && rng.chance(periodic));
      bounds.min[axis] = domain.periodic[axis] ? 0 : low;
      bounds.max[axis] = domain.periodic[axis] ? domain.length[axis] : high;
    }
    if (rng.chance(0.7)) tilt_some(rng, domain, [&](double length) { return length * rng.uniform(-2, 2); });
    map = hg::FixedPoint::over(bounds, domain, unit * rng.uniform());
    farthest_ = rng.chance(0.4) ? 1 : (rng.chance(0.3) ? 2 : (domain.is_tilted() ? 150000 : 1048500));
  }

  // In the box; on periodic axes also box lengths away: one or two, or in some spaces as many as are allowed. On a face
  // now and then.
  void any_center(Rng &rng, double *center) const {
    for (int axis = 0; axis < domain.dimension; axis++) {
      center[axis] = any_inside(rng, axis);
      if (domain.periodic[axis] && rng.chance(0.5)) {
        center[axis] += rng.integer(-farthest_, farthest_) * domain.length[axis];
      }
    }
    if (is_allowed(center)) return;
    for (int axis = 0; axis < domain.dimension; axis++) center[axis] = any_inside(rng, axis);
  }
  bool is_allowed(const double *center) const { return domain.outside(center).boxes < domain.most_outside(); }

  // A map whose coordinates wrap, for particles that wide and as far outside the box as any.
  hg::FixedPoint wrapping(double largest) const {
    return hg::FixedPoint::wrapping(bounds, domain, largest, hg::kMaxWraps);
  }

  hg::Domain domain;
  hg::Bounds bounds;
  hg::FixedPoint map;

 private:
  double any_inside(Rng &rng, int axis) const {
    const double low = domain.box_min[axis], high = domain.box_max[axis];
    const double x = rng.chance(0.1) ? (rng.chance(0.5) ? low : high) : low + rng.uniform() * domain.length[axis];
    return std::fmin(x, high);
  }

  int farthest_;
};

// What the centres span, as kernels are told.
inline std::array<hg::Interval, 3> extent_of(const std::vector<double> &centers, int dimension) {
  std::array<hg::Interval, 3> extent{};
  for (size_t i = 0; i < centers.size(); i++) {
    hg::Interval &along = extent[i % static_cast<size_t>(dimension)];
    const bool first = i < static_cast<size_t>(dimension);
    along.least = first ? centers[i] : std::min(along.least, centers[i]);
    along.greatest = first ? centers[i] : std::max(along.greatest, centers[i]);
  }
  return extent;
}

}  // namespace hgtest
