// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The fast test of a pair of points, written down plainly, and what it may say in real arithmetic.
#pragma once

#include "src/exact/fast_test.hpp"
#include "src/kernels/points.hpp"
#include "tests/unit/checks.hpp"

#include <hgrid/types.h>

#include <algorithm>
#include <cmath>

namespace hgtest {

// Two positions that were floored, wrapped and shifted across the box are at most this many quanta farther from or
// nearer to each other than they should be, in any rounding mode (docs/theory/exactness.md).
inline constexpr long double kQuantisation = 6.08L;

struct Verdict {
  bool possible, sure;
};

inline float plain_reach(int32_t interaction, float a, float b) {
  return interaction == HG_CONTACT ? a + b : std::max(a, b);
}

inline Verdict plain_test(const hg::Point &a, const hg::Point &b, int32_t interaction, float band_constant) {
  const float dx = static_cast<float>(a.x - b.x), dy = static_cast<float>(a.y - b.y),
              dz = static_cast<float>(a.z - b.z);
  const float reach = plain_reach(interaction, a.radius, b.radius);
  const float t = (dx * dx + dy * dy + dz * dz) - reach * reach;
  const float band = reach * (reach * hg::kBandSquare + hg::kBandLinear) + band_constant;
  return {t < band, t + band < 0.0f};
}

// No pair may be lost that could interact, none may be called sure that could not, and none may be found that is
// farther than the band is wide. Differences and squares of 32 bits are exact in long double.
inline void require_truthful(const hg::Point &a, const hg::Point &b, int32_t interaction, const Verdict &verdict) {
  const long double dx = static_cast<long double>(a.x) - b.x, dy = static_cast<long double>(a.y) - b.y;
  const long double dz = static_cast<long double>(a.z) - b.z, d2 = dx * dx + dy * dy + dz * dz, d = std::sqrt(d2);
  const auto ra = static_cast<long double>(a.radius), rb = static_cast<long double>(b.radius);
  const long double reach = interaction == HG_CONTACT ? ra + rb : std::max(ra, rb);
  const long double slope = hg::kBandLinear + static_cast<long double>(hg::kBandSquare) * reach;
  require(verdict.possible || d >= reach + kQuantisation, "missed: distance %.9Lg, reach %.9Lg quanta", d, reach);
  require(!verdict.possible || d2 < (reach * reach + reach * slope + hg::kBandConstant) * (1 + 0x1p-20L),
          "too far: distance %.9Lg, reach %.9Lg quanta", d, reach);
  require(!verdict.sure || d <= reach - kQuantisation, "not asked about: distance %.9Lg, reach %.9Lg quanta", d, reach);
}

}  // namespace hgtest
