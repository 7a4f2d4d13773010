// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The first look at the caller's arrays, one source for all instruction sets: copies them, finds their extremes and
// whether every number is finite, in one pass while the numbers are in cache. Plain loops, as in build.hpp.
#pragma once

#include "src/kernels/kernel_set.hpp"

#include <cmath>
#include <cstring>

namespace hg {
namespace {

constexpr size_t kInputChunk = 512;  // particles that fit into the nearest cache twice

// Of the columns of a [count][Columns] array, count > 0, 8 rows side by side.
template <size_t Columns>
class ColumnCheck {
  static constexpr size_t kAbreast = 8 * Columns;

 public:
  explicit ColumnCheck(const double *first) {
    for (size_t lane = 0; lane < kAbreast; lane++) {
      least_[lane] = greatest_[lane] = first[lane % Columns];
      not_finite_[lane] = 0;
    }
  }

  void take_all(const double *values, size_t count) {
    const size_t whole = count * Columns / kAbreast * kAbreast;
    for (size_t i = 0; i < whole; i += kAbreast) {
      for (size_t lane = 0; lane < kAbreast; lane++) take(lane, values[i + lane]);
    }
    for (size_t i = whole; i < count * Columns; i++) take(i % Columns, values[i]);
  }

  bool finite() const {
    for (const double n : not_finite_) {
      if (n != 0) return false;
    }
    return true;
  }
  Interval column(size_t c) const {
    Interval all{least_[c], greatest_[c]};
    for (size_t lane = c; lane < kAbreast; lane += Columns) {
      all.least = least_[lane] < all.least ? least_[lane] : all.least;
      all.greatest = greatest_[lane] > all.greatest ? greatest_[lane] : all.greatest;
    }
    return all;
  }

 private:
  void take(size_t lane, double value) {
    least_[lane] = value < least_[lane] ? value : least_[lane];
    greatest_[lane] = value > greatest_[lane] ? value : greatest_[lane];
    not_finite_[lane] += value * 0.0;  // stays 0 unless infinity or NaN comes, and is NaN from then on
  }

  double least_[kAbreast], greatest_[kAbreast], not_finite_[kAbreast];
};

template <size_t D>
InputSummary check_input(const InputArrays &input) {
  InputSummary found{};
  ColumnCheck<D> centers(input.centers);
  const double zero = 0;
  ColumnCheck<1> radii(input.radii != nullptr ? input.radii : &zero);
  for (size_t first = 0; first < input.count; first += kInputChunk) {
    const size_t count = input.count - first < kInputChunk ? input.count - first : kInputChunk;
    centers.take_all(input.centers + first * D, count);
    if (input.center_copy != nullptr) {
      std::memcpy(input.center_copy + first * D, input.centers + first * D, count * D * sizeof(double));
    }
    if (input.radii == nullptr) continue;
    radii.take_all(input.radii + first, count);
    if (input.radius_copy != nullptr) {
      std::memcpy(input.radius_copy + first, input.radii + first, count * sizeof(double));
    }
  }
  found.finite = centers.finite() && radii.finite();
  for (size_t axis = 0; axis < D; axis++) found.center[axis] = centers.column(axis);
  found.radius = radii.column(0);
  return found;
}

// The second look: when all is well, centres are copied over those of before, and how far they go is seen on the way.
template <size_t D>
double move_centers(const double *centers, size_t count, double *copy) {
  constexpr size_t kAbreast = 32;  // coordinates, of whatever axes
  double largest[kAbreast] = {};
  const auto take = [&](size_t lane, size_t i) {
    const double way = std::fabs(centers[i] - copy[i]);
    largest[lane] = way > largest[lane] ? way : largest[lane];
    copy[i] = centers[i];
  };
  const size_t whole = count * D / kAbreast * kAbreast;
  for (size_t i = 0; i < whole; i += kAbreast) {
    for (size_t lane = 0; lane < kAbreast; lane++) take(lane, i + lane);
  }
  for (size_t i = whole; i < count * D; i++) take(0, i);
  for (size_t lane = 1; lane < kAbreast; lane++) largest[0] = largest[lane] > largest[0] ? largest[lane] : largest[0];
  return largest[0];
}

}  // namespace
}  // namespace hg
