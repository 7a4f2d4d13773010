// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Powers and roots with the same bits on every machine.
#pragma once

#include <cmath>

namespace packing {

// base^exponent, exponent >= 0.
inline double power(double base, int exponent) {
  double result = 1;
  for (int k = 0; k < exponent; k++) result *= base;
  return result;
}

// x^(1/degree), x >= 0, degree >= 1, by Newton's iteration from above. std::cbrt and std::pow may differ in their last
// bit between C libraries, and with it every coordinate of a packing.
inline double root(double x, int degree) {
  if (degree == 1 || x == 0) return x;
  if (degree == 2) return std::sqrt(x);
  double found = x > 1 ? x : 1;
  for (;;) {
    const double next = found - (found - x / power(found, degree - 1)) / degree;
    if (!(next < found)) return found;
    found = next;
  }
}

}  // namespace packing
