// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Whole numbers of GMP, and the same formula in quadruple and double precision.
#include "oracle/exact_set.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>

namespace oracle {
namespace {

// value = odd number * 2^exponent; 0 has none.
int exponent_of(double value) {
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(value, &exponent), 53);
  exponent -= 53;
  for (auto whole = static_cast<int64_t>(mantissa); whole % 2 == 0; whole /= 2) exponent++;
  return exponent;
}

// Turns doubles into multiples of 2^least.
class Scale {
 public:
  void include(double value) {
    if (value != 0) least_ = std::min(least_, exponent_of(value));
  }
  mpz_class whole(double value) const {
    if (value == 0) return 0;
    const int exponent = exponent_of(value);
    mpz_class result(std::ldexp(value, -exponent));
    mpz_mul_2exp(result.get_mpz_t(), result.get_mpz_t(), static_cast<unsigned long>(exponent - least_));
    return result;
  }

 private:
  int least_ = 2000;
};

// The nearest image of a difference: |d| <= length / 2.
void fold(mpz_class &d, const mpz_class &length) {
  mpz_class shifted = 2 * d + length, quotient;
  mpz_fdiv_q(quotient.get_mpz_t(), shifted.get_mpz_t(), mpz_class(2 * length).get_mpz_t());
  d -= quotient * length;
}

void fold(__float128 &d, __float128 length) {
  while (2 * d >= length) d -= length;
  while (2 * d < -length) d += length;
}

void fold(double &d, double length) { d -= std::nearbyint(d / length) * length; }

// The set in one kind of numbers.
template <class Number>
struct Numbers {
  std::vector<Number> center[3];
  std::vector<Number> radius;
  Number length[3] = {0, 0, 0};  // 0: open

  bool overlap(size_t i, size_t j) const {
    Number sum = 0;
    for (int k = 0; k < 3; k++) {
      Number d = center[k][i] - center[k][j];
      if (length[k] != 0) fold(d, length[k]);
      sum += d * d;
    }
    const Number reach = radius[i] + radius[j];
    return sum < reach * reach;
  }
};

template <class Number, class Convert>
Numbers<Number> converted(const Set &set, Convert convert) {
  Numbers<Number> numbers;
  for (size_t i = 0; i < set.radii.size(); i++) {
    for (size_t k = 0; k < 3; k++) numbers.center[k].push_back(convert(set.centers[3 * i + k]));
    numbers.radius.push_back(convert(set.radii[i]));
  }
  for (int k = 0; k < 3; k++) {
    if (set.periodic[k]) numbers.length[k] = convert(set.box_max[k]) - convert(set.box_min[k]);
  }
  return numbers;
}

template <class Number>
Pairs all_pairs(const Numbers<Number> &numbers) {
  Pairs pairs;
  for (size_t i = 0; i < numbers.radius.size(); i++) {
    for (size_t j = i + 1; j < numbers.radius.size(); j++) {
      if (numbers.overlap(i, j)) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

Pairs sweep(const Numbers<mpz_class> &numbers) {
  const size_t count = numbers.radius.size();
  std::vector<mpz_class> lower(count);
  std::vector<int32_t> order(count);
  for (size_t i = 0; i < count; i++) lower[i] = numbers.center[0][i] - numbers.radius[i];
  std::iota(order.begin(), order.end(), 0);
  const auto row = [](int32_t i) { return static_cast<size_t>(i); };
  std::sort(order.begin(), order.end(), [&](int32_t i, int32_t j) { return lower[row(i)] < lower[row(j)]; });
  Pairs pairs;
  for (size_t first = 0; first < count; first++) {
    const int32_t i = order[first];
    const mpz_class upper = numbers.center[0][row(i)] + numbers.radius[row(i)];
    for (size_t next = first + 1; next < count && lower[row(order[next])] < upper; next++) {
      const int32_t j = order[next];
      if (numbers.overlap(row(i), row(j))) pairs.emplace_back(std::min(i, j), std::max(i, j));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Scale scale_of(const Set &set) {
  Scale scale;
  for (const double x : set.centers) scale.include(x);
  for (const double r : set.radii) scale.include(r);
  for (int k = 0; k < 3; k++) {
    scale.include(set.box_min[k]);
    scale.include(set.box_max[k]);
  }
  return scale;
}

Numbers<mpz_class> whole_numbers(const Set &set) {
  const Scale scale = scale_of(set);
  return converted<mpz_class>(set, [&](double x) { return scale.whole(x); });
}

}  // namespace

Pairs overlapping_pairs(const Set &set, Arithmetic arithmetic) {
  if (arithmetic == Arithmetic::kFloat128) {
    return all_pairs(converted<__float128>(set, [](double x) { return static_cast<__float128>(x); }));
  }
  if (arithmetic == Arithmetic::kDouble) return all_pairs(converted<double>(set, [](double x) { return x; }));
  return all_pairs(whole_numbers(set));
}

Pairs swept_pairs(const Set &set) {
  if (set.periodic[0]) throw std::invalid_argument("a sweep along x needs an open x axis");
  return sweep(whole_numbers(set));
}

}  // namespace oracle
