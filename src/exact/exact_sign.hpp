// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Compares a sum of squares with a square in real arithmetic on doubles. Integers only: no rounding, no overflow, no
// underflow, whatever the compiler, the rounding mode or the host's flush-to-zero setting.
#pragma once

#include <cstdint>

namespace hg {

// One summand of a coordinate difference or of a reach: value * factor, |factor| <= 2^32.
struct ExactTerm {
  double value;
  int64_t factor;
};

inline constexpr int kMaxExactTerms = 6;

struct ExactSum {
  ExactTerm terms[kMaxExactTerms];
  int count = 0;
  void add(double value, int64_t factor) { terms[count++] = {value, factor}; }
};

// The sign of the sum over axes of difference[axis]^2, less reach^2: -1, 0 or 1.
int exact_order(const ExactSum *difference, int dimension, const ExactSum &reach);

// The double that is nearest to the sum, of two the even one; infinite if it overflows.
double round_exactly(const ExactSum &sum);

}  // namespace hg
