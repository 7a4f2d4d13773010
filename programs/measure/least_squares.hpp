// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Least squares with coefficients that cannot be negative, for a handful of terms; groups of observations have
// constants of their own.
#pragma once

#include <array>
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

namespace detail {

// Gauss elimination with pivoting of a symmetric system; a column without a pivot gets the coefficient 0.
template <size_t Terms>
std::array<double, Terms> solve(std::array<std::array<double, Terms + 1>, Terms> a) {
  std::array<bool, Terms> used{};
  std::array<size_t, Terms> row_of{};
  std::array<bool, Terms> solved{};
  for (size_t k = 0; k < Terms; k++) {
    size_t pivot = Terms;
    for (size_t r = 0; r < Terms; r++) {
      if (!used[r] && a[r][k] * a[r][k] > 0 && (pivot == Terms || a[r][k] * a[r][k] > a[pivot][k] * a[pivot][k])) {
        pivot = r;
      }
    }
    if (pivot == Terms) continue;
    used[pivot] = solved[k] = true;
    row_of[k] = pivot;
    for (size_t r = 0; r < Terms; r++) {
      if (r == pivot) continue;
      const double factor = a[r][k] / a[pivot][k];
      for (size_t c = k; c <= Terms; c++) a[r][c] -= factor * a[pivot][c];
    }
  }
  std::array<double, Terms> result{};
  for (size_t k = 0; k < Terms; k++) {
    if (solved[k]) result[k] = a[row_of[k]][Terms] / a[row_of[k]][k];
  }
  return result;
}

}  // namespace detail

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

// The coefficients >= 0 with the least weighted sum of squared errors, by trying every set of terms that may be above
// 0: exact, and quick for as few terms as 6.
template <size_t Terms>
std::array<double, Terms> fit_non_negative(const std::vector<Observation<Terms>> &grouped) {
  const std::vector<Observation<Terms>> observations = centered(grouped);
  std::array<std::array<double, Terms + 1>, Terms> normal{};
  double least = 0;  // of all coefficients 0
  for (const Observation<Terms> &o : observations) {
    for (size_t r = 0; r < Terms; r++) {
      for (size_t c = 0; c < Terms; c++) normal[r][c] += o.weight * o.term[r] * o.term[c];
      normal[r][Terms] += o.weight * o.term[r] * o.value;
    }
    least += o.weight * o.value * o.value;
  }
  std::array<double, Terms> best{};
  for (size_t set = 1; set < size_t{1} << Terms; set++) {
    auto system = normal;
    for (size_t r = 0; r < Terms; r++) {
      for (size_t c = 0; c <= Terms; c++) {
        const bool in = (set >> r & 1) != 0 && (c == Terms || (set >> c & 1) != 0);
        if (!in) system[r][c] = 0;
      }
    }
    const std::array<double, Terms> found = detail::solve<Terms>(system);
    double squares = 0;
    bool valid = true;
    for (const double x : found) valid = valid && x >= 0;
    for (const Observation<Terms> &o : observations) {
      const double error = sum_of(found, o.term) - o.value;
      squares += o.weight * error * error;
    }
    if (!valid || !(squares < least)) continue;
    least = squares;
    best = found;
  }
  return best;
}

}  // namespace measure
