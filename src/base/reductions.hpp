// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Sums and maxima of many numbers. Several running values side by side, as compilers may not reorder operations on
// doubles on their own.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hg {

// How many of values[0 .. count) are at most `limit`, and the greatest of these (`fallback` if none is).
struct Within {
  size_t count;
  double greatest;
};
inline Within within(const double *values, size_t count, double limit, double fallback) {
  constexpr size_t kAbreast = 8;
  double greatest[kAbreast];
  int64_t inside[kAbreast] = {};
  for (double &g : greatest) g = fallback;
  const size_t whole = count - count % kAbreast;
  for (size_t i = 0; i < whole; i += kAbreast) {
    for (size_t lane = 0; lane < kAbreast; lane++) {
      const double value = values[i + lane] <= limit ? values[i + lane] : fallback;
      inside[lane] += values[i + lane] <= limit;
      greatest[lane] = value > greatest[lane] ? value : greatest[lane];
    }
  }
  Within result{0, fallback};
  for (size_t lane = 0; lane < kAbreast; lane++) {
    result.count += static_cast<size_t>(inside[lane]);
    result.greatest = greatest[lane] > result.greatest ? greatest[lane] : result.greatest;
  }
  for (size_t i = whole; i < count; i++) {
    if (values[i] > limit) continue;
    result.count++;
    result.greatest = values[i] > result.greatest ? values[i] : result.greatest;
  }
  return result;
}

// A sum whose order does not depend on the compiler.
inline double sum_of(const double *values, size_t count) {
  constexpr size_t kAbreast = 8;
  double sum[kAbreast] = {};
  const size_t whole = count - count % kAbreast;
  for (size_t i = 0; i < whole; i += kAbreast) {
    for (size_t lane = 0; lane < kAbreast; lane++) sum[lane] += values[i + lane];
  }
  for (size_t i = whole; i < count; i++) sum[0] += values[i];
  double result = 0;
  for (const double s : sum) result += s;
  return result;
}

}  // namespace hg
