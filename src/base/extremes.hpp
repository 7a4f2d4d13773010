// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Least and greatest of many numbers. Several running values side by side, as compilers may not reorder comparisons of
// doubles on their own.
#pragma once

#include "src/kernels/kernel.hpp"

#include <cstddef>
#include <cstdint>

namespace hg {

// Of columns of a [count][Columns] array, count > 0.
template <size_t Columns>
void column_extremes(const double *values, size_t count, Extremes *columns) {
  constexpr size_t kAbreast = 4 * Columns;
  double least[kAbreast], greatest[kAbreast];
  for (size_t k = 0; k < kAbreast; k++) least[k] = greatest[k] = values[k % Columns];
  const size_t whole = count / 4 * kAbreast;
  for (size_t i = 0; i < whole; i += kAbreast) {
    for (size_t k = 0; k < kAbreast; k++) {
      const double value = values[i + k];
      least[k] = value < least[k] ? value : least[k];
      greatest[k] = value > greatest[k] ? value : greatest[k];
    }
  }
  for (size_t k = 0; k < Columns; k++) columns[k] = {least[k], greatest[k]};
  const auto take = [columns](size_t column, double low, double high) {
    Extremes &e = columns[column];
    e.least = low < e.least ? low : e.least;
    e.greatest = high > e.greatest ? high : e.greatest;
  };
  for (size_t k = Columns; k < kAbreast; k++) take(k % Columns, least[k], greatest[k]);
  for (size_t i = whole; i < count * Columns; i++) take(i % Columns, values[i], values[i]);
}

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
    for (size_t k = 0; k < kAbreast; k++) {
      const double value = values[i + k] <= limit ? values[i + k] : fallback;
      inside[k] += values[i + k] <= limit;
      greatest[k] = value > greatest[k] ? value : greatest[k];
    }
  }
  Within result{0, fallback};
  for (size_t k = 0; k < kAbreast; k++) {
    result.count += static_cast<size_t>(inside[k]);
    result.greatest = greatest[k] > result.greatest ? greatest[k] : result.greatest;
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
    for (size_t k = 0; k < kAbreast; k++) sum[k] += values[i + k];
  }
  for (size_t i = whole; i < count; i++) sum[0] += values[i];
  double result = 0;
  for (const double s : sum) result += s;
  return result;
}

}  // namespace hg
