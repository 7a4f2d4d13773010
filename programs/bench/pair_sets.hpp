// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Comparing lists of pairs as sets.
#pragma once

#include "particles/particle_set.hpp"

#include <hgrid/types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

namespace bench {

inline bool before(const hg_pair &p, const hg_pair &q) { return p.a != q.a ? p.a < q.a : p.b < q.b; }

inline std::vector<hg_pair> sorted(const hg_pair *pairs, size_t count) {
  std::vector<hg_pair> result(pairs, pairs + count);
  std::sort(result.begin(), result.end(), before);
  return result;
}

// The pairs that are in one list but not as often in the other. Both lists must be sorted.
inline std::vector<hg_pair> differences(const std::vector<hg_pair> &one, const std::vector<hg_pair> &other) {
  std::vector<hg_pair> result;
  std::set_symmetric_difference(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(result), before);
  return result;
}

// How far (d^2 - s^2) / s^2 can be from 0 where the double predicate errs: sum and squares carry a relative error below
// 8 * 2^-53.
inline constexpr double kDoubleRounding = 8 * std::numeric_limits<double>::epsilon();
// HG_FLOAT takes distances below s (1 + 2^-47) at most; the square doubles that, and a little for the rounding here.
inline constexpr double kFloatDistance = 0x1.01p-46;

// Whether two particles, or the nearest images of them, touch within a relative distance of the squares; long double
// leaves room to judge that. Across a periodic box its edge is rounded too.
inline bool touch_within(const particles::ParticleSet &set, const hg_pair &pair, double relative) {
  const size_t a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
  const size_t d = static_cast<size_t>(set.dimension);
  long double square = 0, longest_edge = 0;
  for (size_t k = 0; k < d; k++) {
    long double difference = static_cast<long double>(set.centers[a * d + k]) - set.centers[b * d + k];
    if (set.periodic[k] != 0) {
      const long double edge = static_cast<long double>(set.box_max[k]) - set.box_min[k];
      difference = std::remainder(difference, edge);
      longest_edge = std::max(longest_edge, edge);
    }
    square += difference * difference;
  }
  const long double sum = static_cast<long double>(set.radii[a]) + set.radii[b];
  return std::fabs(square - sum * sum) <= relative * sum * (sum + longest_edge);
}

}  // namespace bench
