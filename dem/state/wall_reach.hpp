// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which walls a particle reaches.
#pragma once

#include "dem/state/boundary.hpp"

#include <hgrid/hgrid.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace dem {

// The planes a surface must pass to reach a wall; axes without walls have none.
template <int D, class Real>
struct WallReach {
  Vec<D, Real> low, high;

  // `range` is how far walls act beyond touching.
  WallReach(const Boundary<D, Real> &boundary, Real range) {
    constexpr Real kNever = std::numeric_limits<Real>::infinity();
    for (int k = 0; k < D; k++) {
      const bool walled = boundary.walled[k];
      low[k] = walled ? boundary.low[k] + range : -kNever;
      high[k] = walled ? boundary.high[k] - range : kNever;
    }
  }

  bool below(const Vec<D, Real> &x, Real r, int k) const { return x[k] - r < low[k]; }
  bool above(const Vec<D, Real> &x, Real r, int k) const { return x[k] + r > high[k]; }

  bool any(const Vec<D, Real> &x, Real r) const {
    bool reached = false;
    for (int k = 0; k < D; k++) reached |= below(x, r, k) | above(x, r, k);  // no branch per plane
    return reached;
  }

  void list(const Vec<D, Real> &x, Real r, size_t i, std::vector<hg_pair> &contacts) const {
    for (int k = 0; k < D; k++) {
      if (below(x, r, k)) contacts.push_back({static_cast<int32_t>(i), 2 * k});
      if (above(x, r, k)) contacts.push_back({static_cast<int32_t>(i), 2 * k + 1});
    }
  }
};

}  // namespace dem
