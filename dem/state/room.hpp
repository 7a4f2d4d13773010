// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How much farther particles may move before pairs that touch could be missing from the list.
#pragma once

#include "dem/base/parallel.hpp"
#include "dem/state/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace dem {

// Half the skin is there for each particle. Every step takes off the way of the fastest, which costs nothing to know;
// only when all is spent, the true ways are looked at.
template <int D, class Real>
class Room {
 public:
  // `half_skin` 0: pairs are searched for in each step. `straight`: ways can be told from the places; not where
  // particles are put elsewhere or grow.
  Room(double half_skin, bool straight) : half_skin_(half_skin), straight_(straight) {}

  // Pairs have just been searched for.
  void renew(const Bodies<D, Real> &bodies) {
    left_ = half_skin_;
    if (half_skin_ == 0) return;
    extent_ = 0;
    for (const Row<Real> &row : bodies.places) {
      for (int k = 0; k < D; k++) extent_ = std::max(extent_, std::abs(static_cast<double>(row.numbers[k])));
    }
    if (straight_) start_ = bodies.places;
  }

  // Particles have moved by no more than `way`, and rounding.
  void spend(double way) {
    const double rounding = 2 * D * std::numeric_limits<Real>::epsilon() * (extent_ + half_skin_);
    last_ = way + rounding;
    left_ -= last_;
  }

  // Whether the list still holds.
  bool holds(const Bodies<D, Real> &bodies, int threads) {
    if (left_ > 0) return true;
    if (!straight_ || start_.empty() || !std::isfinite(left_)) return false;
    left_ = half_skin_ - farthest(bodies, threads);
    // A look costs a fraction of a search, but not in every step.
    constexpr double kStepsPerLook = 4;
    return left_ > kStepsPerLook * last_;
  }

  // Nothing is known of the list any more.
  void forget() {
    left_ = -1;
    start_.clear();
  }

  size_t bytes() const { return sizeof(Row<Real>) * start_.capacity(); }

 private:
  double farthest(const Bodies<D, Real> &bodies, int threads) const {
    std::vector<double> squares(static_cast<size_t>(threads));
    in_parts(threads, start_.size(), [&](int part, size_t first, size_t last) {
      Real most = 0;
      for (size_t i = first; i < last; i++) {
        const Real way = (bodies.position(i) - start_[i].template vector<D>()).squaredNorm();
        most = way > most ? way : most;
      }
      squares[static_cast<size_t>(part)] = static_cast<double>(most);
    });
    const double way = std::sqrt(*std::max_element(squares.begin(), squares.end()));
    return way * (1 + 4 * std::numeric_limits<Real>::epsilon());
  }

  double half_skin_;
  bool straight_;
  double left_ = -1, last_ = 0, extent_ = 0;
  LargeArray<Row<Real>> start_;  // places of the last search
};

}  // namespace dem
