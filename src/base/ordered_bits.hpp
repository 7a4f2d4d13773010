// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Doubles by their bits. Those >= 0 order as their bits do, and a host that has subnormals taken for zero changes
// nothing: there `x < 0` and `a > b` do not see all of them.
#pragma once

#include "src/base/arithmetic.hpp"

#include <cstdint>
#include <cstring>

namespace hg {

inline uint64_t bits_of(double x) {
  uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof x);
  return bits;
}

inline double from_bits(uint64_t bits) {
  double x = 0;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

// -0.0 is not negative. NaN may be either.
inline bool is_negative(double x) { return bits_of(x) > uint64_t{1} << 63; }

// Integers that order as the doubles do, infinite ones too; both zeros are one.
inline int64_t order_of(double x) {
  const uint64_t bits = bits_of(x), sign = uint64_t{1} << 63;
  const auto size = static_cast<int64_t>(bits & ~sign);
  return (bits & sign) != 0 ? -size : size;
}

// Of a and b, both >= 0.
inline double larger_of(double a, double b) { return bits_of(a) > bits_of(b) ? a : b; }

}  // namespace hg
