// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The lattice of shifts that the edges of the periodic cell span. How short its vectors are says whether two particles
// can meet twice.
#pragma once

#include "src/exact/domain.hpp"
#include "src/exact/exact_sign.hpp"

#include <limits>

namespace hg {

// Adds times (n_a a + n_b b + n_c c) on one axis, in real arithmetic on the box that the caller gave.
void add_shift(ExactSum &sum, const Domain &domain, int axis, const Shift &shift, int64_t times = 1);

// Some vectors that are not 0: of each pair of opposite ones one, and all that are shortest among them.
struct ShortVectors {
  static constexpr int kMost = 13;
  int count = 0;
  Shift shift[kMost];
  double shortest = std::numeric_limits<double>::infinity();  // length, rounded
};

// A tilted cell may be this many times longer than thin.
inline constexpr double kMostStretched = 1073741824.0;  // 2^30

// Of a domain whose tilts and lengths are within their limits.
ShortVectors find_short_vectors(const Domain &domain);

// True if the vector is shorter than `length`, exactly.
bool is_shorter(const Domain &domain, const Shift &shift, const ExactSum &length);

}  // namespace hg
