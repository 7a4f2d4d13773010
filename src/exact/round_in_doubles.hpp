// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A sum of doubles times whole factors, rounded once, in double arithmetic: nearly always possible, and much faster
// than round_exactly.
#pragma once

#include "src/exact/exact_sign.hpp"

#include <cmath>

namespace hg {

// Keeps what each addition rounds off, and bounds what even these rests round off.
class CarefulSum {
 public:
  void add(double term) {
    double rounded_off = 0;
    sum_ = add(sum_, term, rounded_off);
    double lost = 0;
    rest_ = add(rest_, rounded_off, lost);
    lost_ += std::fabs(lost);
  }

  // The rounded sum. False if it is too near to the middle between two doubles to be sure of it. If nothing was lost,
  // the last addition is the only one that rounds; the bound must tell when it is added to what that rounds off.
  bool round(double &rounded) const {
    double rest = 0;
    rounded = add(sum_, rest_, rest);
    if (lost_ == 0) return true;
    const double bound = 2 * lost_ + 0x1p-50 * std::fabs(rest);
    return rounded + (rest + bound) == rounded && rounded + (rest - bound) == rounded;
  }

 private:
  // Knuth 1969.
  static double add(double x, double y, double &rounded_off) {
    const double sum = x + y, added = sum - x;
    rounded_off = (x - (sum - added)) + (y - added);
    return sum;
  }

  double sum_ = 0, rest_ = 0, lost_ = 0;
};

// False if it is not sure of the last bit, or if the terms are too large for it. Factors have at most 27 bits, so that
// products with either half of a double (Dekker 1971) are exact.
inline bool round_in_doubles(const ExactSum &sum, double &rounded) {
  CarefulSum total;
  for (int k = 0; k < sum.count; k++) {
    const double value = sum.terms[k].value, scaled = value * 0x1.0000002p27;
    const double high = scaled - (scaled - value), factor = static_cast<double>(sum.terms[k].factor);
    total.add(high * factor);
    total.add((value - high) * factor);
  }
  return total.round(rounded);
}

}  // namespace hg
