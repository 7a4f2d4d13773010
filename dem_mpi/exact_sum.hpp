// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Sums of doubles without any rounding, so that they do not depend on the order of the terms, nor on which rank adds
// which. A sum is one long number in fixed point, as wide as doubles reach (Kulisch).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace dem::ranks {

class ExactSum {
 public:
  // Limbs of 32 bits and what carries, from 2^-1074 up; the last counts terms that are not finite. They add up over
  // ranks one by one. Each term adds less than 2^33 to a limb: room for 2^30 terms on all ranks together.
  static constexpr size_t kLimbs = 70, kWidth = kLimbs + 1;

  void add(double term) {
    if (term == 0) return;
    if (!std::isfinite(term)) {
      limbs_[kLimbs]++;
      return;
    }
    uint64_t bits = 0;
    std::memcpy(&bits, &term, sizeof bits);
    const uint64_t exponent = bits >> 52 & 0x7ff, fraction = bits & ((uint64_t{1} << 52) - 1);
    const uint64_t number = exponent > 0 ? fraction | uint64_t{1} << 52 : fraction;
    const uint64_t place = exponent > 0 ? exponent - 1 : 0;  // of its last bit above 2^-1074
    const size_t limb = place / 32;
    const unsigned shift = place % 32;
    const uint64_t low = (number & kMask) << shift, high = (number >> 32) << shift;
    const int64_t sign = term < 0 ? -1 : 1;
    limbs_[limb] += sign * static_cast<int64_t>(low & kMask);
    limbs_[limb + 1] += sign * static_cast<int64_t>((low >> 32) + (high & kMask));
    limbs_[limb + 2] += sign * static_cast<int64_t>(high >> 32);
  }

  // To within a unit in its last place; the same wherever the limbs are. NaN if a term was not finite.
  double value() const {
    if (limbs_[kLimbs] != 0) return std::numeric_limits<double>::quiet_NaN();
    std::array<int64_t, kWidth> limbs = carried(limbs_);
    const bool negative = limbs[kLimbs - 1] < 0;
    if (negative) {
      for (int64_t &limb : limbs) limb = -limb;
      limbs = carried(limbs);
    }
    size_t top = kLimbs;
    while (top > 1 && limbs[top - 1] == 0) top--;
    double value = 0;
    for (size_t k = 0; k < 3 && k < top; k++) {
      value += std::ldexp(static_cast<double>(limbs[top - 1 - k]), 32 * static_cast<int>(top - 1 - k) - 1074);
    }
    return negative ? -value : value;
  }

  int64_t *limbs() { return limbs_.data(); }
  const int64_t *limbs() const { return limbs_.data(); }

 private:
  static constexpr uint64_t kMask = 0xffffffffu;

  // Each limb but the last below 2^32 and not negative.
  static std::array<int64_t, kWidth> carried(std::array<int64_t, kWidth> limbs) {
    for (size_t k = 0; k + 1 < kLimbs; k++) {
      const auto low = static_cast<int64_t>(static_cast<uint64_t>(limbs[k]) & kMask);
      limbs[k + 1] += (limbs[k] - low) / (int64_t{1} << 32);
      limbs[k] = low;
    }
    return limbs;
  }

  std::array<int64_t, kWidth> limbs_{};
};

}  // namespace dem::ranks
