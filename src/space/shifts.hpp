// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which shifts of the periodic cell take one box of places near another one.
#pragma once

#include "src/exact/domain.hpp"

#include <algorithm>
#include <cmath>

namespace hg {

// A box of places, in the caller's lengths or in quanta.
struct PlaceBox {
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};

  static PlaceBox at(const double *place, int dimension) {
    PlaceBox box;
    for (int axis = 0; axis < dimension; axis++) box.low[axis] = box.high[axis] = place[axis];
    return box;
  }
};

// All numbers of edges n with low <= n * length <= high.
struct EdgeRange {
  double first, last;
  static EdgeRange within(double low, double high, double length) {
    if (low <= 0 && high >= 0 && low > -length && high < length) return {0, 0};  // mostly, and without a quotient
    return {std::ceil(low / length), std::floor(high / length)};
  }
  double count() const { return std::max(0.0, last - first + 1); }
};

// Calls visit(shift) for each shift that makes some place of `from` lie in `to`, by c, then b, then a, ascending. Open
// axes are not looked at. Ends that lie exactly on a shift may be missed: boxes must have some slack.
template <class Visit>
void visit_shifts(const Domain &domain, const PlaceBox &from, const PlaceBox &to, Visit &&visit) {
  const auto range = [&](int axis, const Shift &higher) {
    if (axis >= domain.dimension || !domain.periodic[axis]) return EdgeRange{0, 0};
    const double moved = domain.shifted(axis, higher);
    return EdgeRange::within(to.low[axis] - from.high[axis] - moved, to.high[axis] - from.low[axis] - moved,
                             domain.length[axis]);
  };
  const auto along = [&](int axis, Shift shift, auto &&next) {
    const EdgeRange edges = range(axis, shift);
    const auto count = static_cast<int64_t>(edges.count());
    for (int64_t k = 0; k < count; k++) {
      shift.n[axis] = static_cast<int32_t>(edges.first + static_cast<double>(k));
      next(shift);
    }
  };
  along(2, Shift{}, [&](const Shift &c) { along(1, c, [&](const Shift &b) { along(0, b, visit); }); });
}

}  // namespace hg
