// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The first look at the caller's arrays, one source for all instruction sets: copies them, finds their extremes and
// whether every number is finite, in one pass while the numbers are in cache. Plain loops, as in keys.hpp.
#pragma once

#include "src/kernels/kernel.hpp"

#include <cstring>

namespace hg {
namespace {

constexpr size_t kSurveyChunk = 512;  // particles that fit into the nearest cache twice

// Extremes of the columns of a [count][Columns] array, count > 0, 8 rows side by side.
template <size_t Columns>
class ColumnSurvey {
  static constexpr size_t kAbreast = 8 * Columns;

 public:
  explicit ColumnSurvey(const double *first) {
    for (size_t k = 0; k < kAbreast; k++) {
      least_[k] = greatest_[k] = first[k % Columns];
      not_finite_[k] = 0;
    }
  }

  void look_at(const double *values, size_t count) {
    const size_t whole = count * Columns / kAbreast * kAbreast;
    for (size_t i = 0; i < whole; i += kAbreast) {
      for (size_t k = 0; k < kAbreast; k++) take(k, values[i + k]);
    }
    for (size_t i = whole; i < count * Columns; i++) take(i % Columns, values[i]);
  }

  bool finite() const {
    for (const double n : not_finite_) {
      if (n != 0) return false;
    }
    return true;
  }
  Extremes column(size_t c) const {
    Extremes all{least_[c], greatest_[c]};
    for (size_t k = c; k < kAbreast; k += Columns) {
      all.least = least_[k] < all.least ? least_[k] : all.least;
      all.greatest = greatest_[k] > all.greatest ? greatest_[k] : all.greatest;
    }
    return all;
  }

 private:
  void take(size_t k, double value) {
    least_[k] = value < least_[k] ? value : least_[k];
    greatest_[k] = value > greatest_[k] ? value : greatest_[k];
    not_finite_[k] += value * 0.0;  // stays 0 unless infinity or NaN comes, and is NaN from then on
  }

  double least_[kAbreast], greatest_[kAbreast], not_finite_[kAbreast];
};

template <size_t D>
Survey survey(const SurveyInput &input) {
  Survey found{};
  ColumnSurvey<D> centers(input.centers);
  const double zero = 0;
  ColumnSurvey<1> radii(input.radii != nullptr ? input.radii : &zero);
  for (size_t first = 0; first < input.count; first += kSurveyChunk) {
    const size_t count = input.count - first < kSurveyChunk ? input.count - first : kSurveyChunk;
    centers.look_at(input.centers + first * D, count);
    if (input.center_copy != nullptr) {
      std::memcpy(input.center_copy + first * D, input.centers + first * D, count * D * sizeof(double));
    }
    if (input.radii == nullptr) continue;
    radii.look_at(input.radii + first, count);
    if (input.radius_copy != nullptr) {
      std::memcpy(input.radius_copy + first, input.radii + first, count * sizeof(double));
    }
  }
  found.finite = centers.finite() && radii.finite();
  for (size_t k = 0; k < D; k++) found.axis[k] = centers.column(k);
  found.radius = radii.column(0);
  return found;
}

}  // namespace
}  // namespace hg
