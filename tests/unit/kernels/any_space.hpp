// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Spaces of any size and place with their map to quanta, and centres in them.
#pragma once

#include "src/base/interval.hpp"
#include "src/space/fixed_point.hpp"
#include "tests/support/rng.hpp"
#include "tests/unit/domains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace hgtest {

class Space {
 public:
  // Ordinary lengths mostly, else from subnormal numbers to near the greatest; at the origin, or far from it at a power
  // of two, where numbers below the space are finer than those in it.
  explicit Space(Rng &rng) : domain(open_space(rng.integer(2, 3))) {
    const double unit = std::ldexp(1.0, rng.chance(0.7) ? rng.integer(-30, 30) : rng.integer(-1074, 990));
    const double far = rng.chance(0.5) ? 0 : std::ldexp(rng.chance(0.5) ? unit : -unit, rng.integer(0, 30));
    for (int axis = 0; axis < domain.dimension; axis++) {
      const double low = far, high = far + unit * (rng.chance(0.2) ? 1 : rng.uniform(1, 2));
      set_box(domain, axis, low, high, high > low && rng.chance(0.4));
      bounds.min[axis] = domain.periodic[axis] ? 0 : low;
      bounds.max[axis] = domain.periodic[axis] ? domain.length[axis] : high;
    }
    map = hg::FixedPoint::over(bounds, domain, unit * rng.uniform());
    farthest_ = rng.chance(0.4) ? 1 : (rng.chance(0.3) ? 2 : 1048500);
  }

  // In the box; on periodic axes also box lengths away: one or two, or in some spaces up to 2^20. On a face now and
  // then.
  double any_center(Rng &rng, int axis) const {
    const double low = domain.box_min[axis], high = domain.box_max[axis];
    const double x = rng.chance(0.1) ? (rng.chance(0.5) ? low : high) : low + rng.uniform() * domain.length[axis];
    if (!domain.periodic[axis] || rng.chance(0.5)) return std::fmin(x, high);
    return x + rng.integer(-farthest_, farthest_) * domain.length[axis];
  }

  // A map whose coordinates wrap, for particles that wide and as far outside the box as any.
  hg::FixedPoint wrapping(double largest) const {
    return hg::FixedPoint::wrapping(bounds, domain, largest, hg::kMaxWraps);
  }

  hg::Domain domain;
  hg::Bounds bounds;
  hg::FixedPoint map;

 private:
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
