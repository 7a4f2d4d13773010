// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Least squares with coefficients that cannot be negative, for a handful of terms; groups of observations have
// constants of their own.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace measure {

// value ~ constant of the group + sum over k of coefficient[k] * term[k].
template <size_t Terms>
struct Observation {
  size_t group;
  std::array<double, Terms> term;
  double value;
  double weight;
};

// Terms and value less their weighted means in each group: what is left does not know the groups' constants.
template <size_t Terms>
std::vector<Observation<Terms>> centered(std::vector<Observation<Terms>> observations) {
  std::vector<Observation<Terms>> mean;
  for (const Observation<Terms> &o : observations) {
    if (o.group >= mean.size()) mean.resize(o.group + 1);
    Observation<Terms> &m = mean[o.group];
    for (size_t k = 0; k < Terms; k++) m.term[k] += o.weight * o.term[k];
    m.value += o.weight * o.value;
    m.weight += o.weight;
  }
  for (Observation<Terms> &o : observations) {
    const Observation<Terms> &m = mean[o.group];
    for (size_t k = 0; k < Terms; k++) o.term[k] -= m.term[k] / m.weight;
    o.value -= m.value / m.weight;
  }
  return observations;
}

template <size_t Terms>
double sum_of(const std::array<double, Terms> &coefficient, const std::array<double, Terms> &term) {
  double sum = 0;
  for (size_t k = 0; k < Terms; k++) sum += coefficient[k] * term[k];
  return sum;
}

// The coefficients >= 0 with the least weighted sum of squared errors. One after the other becomes the best that it can
// be beside the others, over and over: the sum is convex, so that this leads to its least. A term that is constant in
// all groups gets the coefficient 0.
template <size_t Terms>
std::array<double, Terms> fit_non_negative(const std::vector<Observation<Terms>> &grouped) {
  constexpr int kMostRounds = 1000000;  // terms that are nearly alike take thousands
  std::array<std::array<double, Terms>, Terms> product{};
  std::array<double, Terms> with_value{}, coefficient{};
  for (const Observation<Terms> &o : centered(grouped)) {
    for (size_t r = 0; r < Terms; r++) {
      for (size_t c = 0; c < Terms; c++) product[r][c] += o.weight * o.term[r] * o.term[c];
      with_value[r] += o.weight * o.term[r] * o.value;
    }
  }
  bool changes = true;
  for (int round = 0; changes && round < kMostRounds; round++) {
    changes = false;
    for (size_t k = 0; k < Terms; k++) {
      if (!(product[k][k] > 0)) continue;
      const double misses = with_value[k] - sum_of(product[k], coefficient);
      const double next = std::max(0.0, coefficient[k] + misses / product[k][k]);
      changes = changes || std::fabs(next - coefficient[k]) > 1e-15 * next;
      coefficient[k] = next;
    }
  }
  return coefficient;
}

}  // namespace measure
