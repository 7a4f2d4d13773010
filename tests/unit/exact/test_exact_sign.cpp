// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// exact_order() and round_exactly() against rational numbers: all exponents, cancelling sums, exact ties.
#include "src/exact/exact_sign.hpp"
#include "tests/support/rounded.hpp"
#include "tests/unit/checks.hpp"

#include <gmpxx.h>

#include <cmath>
#include <limits>

namespace {

using namespace hgtest;
using hg::exact_order;
using hg::ExactSum;

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kTiniest = std::numeric_limits<double>::denorm_min();

mpq_class rational(const ExactSum &sum) {
  mpq_class total = 0;
  for (int k = 0; k < sum.count; k++) {
    total += mpq_class(sum.terms[k].value) * mpq_class(static_cast<double>(sum.terms[k].factor));
  }
  return total;
}

int rational_order(const ExactSum *difference, int dimension, const ExactSum &reach) {
  mpq_class squares = 0;
  for (int axis = 0; axis < dimension; axis++) squares += rational(difference[axis]) * rational(difference[axis]);
  const int order = cmp(squares, mpq_class(rational(reach) * rational(reach)));
  return order < 0 ? -1 : (order > 0 ? 1 : 0);
}

void compare(const char *what, const ExactSum *difference, int dimension, const ExactSum &reach) {
  const int expected = rational_order(difference, dimension, reach);
  require(exact_order(difference, dimension, reach) == expected, "%s: in %dD the answer must be %d", what, dimension,
          expected);
}

double any_double(Rng &rng) {
  const double sign = rng.chance(0.5) ? -1 : 1;
  switch (rng.below(8)) {
    case 0:
      return sign * 0.0;
    case 1:
      return sign * kLargest;
    case 2:
      return sign * kTiniest * static_cast<double>(rng.below(1u << 20));
    case 3:
      return sign * std::ldexp(1.0, rng.integer(-1074, 1023));
    case 4:
      return sign * static_cast<double>(rng.below(100));
    default:
      return sign * std::ldexp(1 + rng.uniform(), rng.integer(-1074, 1023));
  }
}

int64_t any_factor(Rng &rng) {
  const int64_t sign = rng.chance(0.5) ? -1 : 1;
  if (rng.chance(0.5)) return sign;
  return sign * static_cast<int64_t>(rng.below((1u << 21) + 1));
}

ExactSum any_sum(Rng &rng) {
  ExactSum sum;
  const int terms = rng.integer(1, hg::kMaxExactTerms);
  for (int k = 0; k < terms; k++) sum.add(any_double(rng), any_factor(rng));
  return sum;
}

void check_any_numbers(uint64_t seed) {
  Rng rng(seed);
  const int dimension = rng.integer(1, 3);
  ExactSum difference[3];
  for (ExactSum &d : difference) d = any_sum(rng);
  compare("any numbers", difference, dimension, any_sum(rng));
}

// Numbers of one size, so that neither side is decided by exponents alone.
void check_similar_numbers(uint64_t seed) {
  Rng rng(seed);
  const int dimension = rng.integer(2, 3);
  const int exponent = rng.integer(-1074, 1000);
  const auto value = [&] { return std::ldexp(rng.uniform(-1, 1), exponent + rng.integer(-3, 3)); };
  ExactSum difference[3], reach;
  for (ExactSum &d : difference) {
    d.add(value(), 1);
    d.add(value(), -1);
    const int64_t boxes = rng.integer(-2, 2);
    if (boxes != 0) d.add(value(), boxes);
  }
  reach.add(value(), 1);
  reach.add(value(), 1);
  compare("similar numbers", difference, dimension, reach);
}

// `total` as a sum whose other terms cancel; none of them lets the sum be formed in doubles.
ExactSum cancelling_sum(Rng &rng, double total, double other) {
  ExactSum sum;
  const int64_t factor = any_factor(rng);
  sum.add(other, factor);
  sum.add(total, 1);
  sum.add(other, -factor);
  return sum;
}

// Pythagorean tuples at any scale: a tie is not less, and the tiniest number more decides.
void check_ties(uint64_t seed) {
  static constexpr int kTuples[5][4] = {{3, 4, 0, 5}, {20, 21, 0, 29}, {2, 3, 6, 7}, {1, 4, 8, 9}, {6, 10, 15, 19}};
  Rng rng(seed);
  const int *tuple = kTuples[rng.below(5)];
  const int dimension = tuple[2] == 0 ? 2 : 3;
  const double scale = std::ldexp(1.0, rng.integer(-1074, 1018));
  ExactSum difference[3];
  for (int axis = 0; axis < 3; axis++) difference[axis] = cancelling_sum(rng, scale * tuple[axis], any_double(rng));
  const ExactSum tie = cancelling_sum(rng, scale * tuple[3], any_double(rng));
  require(exact_order(difference, dimension, tie) == 0, "a tie is not seen");
  ExactSum more = tie, less = tie;
  more.add(kTiniest, 1);
  less.add(kTiniest, -1);
  require(exact_order(difference, dimension, more) < 0, "the tiniest number more is not seen");
  require(exact_order(difference, dimension, less) > 0, "the tiniest number less is not seen");
}

// The reach is the distance rounded, or a few units in the last place beside it.
void check_near_ties(uint64_t seed) {
  Rng rng(seed);
  const int dimension = rng.integer(2, 3);
  ExactSum difference[3], reach;
  double square = 0;
  for (ExactSum &d : difference) {
    const double a = rng.uniform(-1, 1), b = rng.uniform(-1, 1);
    d.add(a, 1);
    d.add(b, -1);
    if (&d - difference < dimension) square += (a - b) * (a - b);
  }
  double r = std::sqrt(square);
  for (int k = rng.integer(0, 2); k > 0; k--) r = std::nextafter(r, rng.chance(0.5) ? 0 : 4);
  reach.add(r, 1);
  compare("near tie", difference, dimension, reach);
}

// The longest integers that can occur: the largest and the tiniest number with the largest factors.
void check_longest(uint64_t seed) {
  Rng rng(seed);
  const int64_t most = int64_t{1} << 32;
  ExactSum difference[3], reach;
  for (ExactSum *sum : {&difference[0], &difference[1], &difference[2], &reach}) {
    const double large = rng.chance(0.5) ? kLargest : 0x1p1023;
    const int64_t sign = rng.chance(0.5) ? -1 : 1;
    for (int k = 0; k < 3; k++) sum->add(large, sign * most);
    sum->add(rng.chance(0.5) ? kTiniest : -kTiniest, most - static_cast<int64_t>(rng.below(2)));
  }
  compare("longest", difference, rng.integer(1, 3), reach);
}

void any_numbers(void **) { assert_true(sweep(5000, check_any_numbers)); }
void similar_numbers(void **) { assert_true(sweep(20000, check_similar_numbers)); }
void ties(void **) { assert_true(sweep(5000, check_ties)); }
void near_ties(void **) { assert_true(sweep(20000, check_near_ties)); }
void longest_integers(void **) { assert_true(sweep(200, check_longest)); }

void nothing_is_less_than_zero(void **) {
  ExactSum zero[3], reach;
  for (ExactSum &d : zero) d.add(0.0, 1);
  reach.add(-0.0, 1);
  assert_int_equal(exact_order(zero, 3, reach), 0);
  reach.add(kTiniest, 1);
  assert_true(exact_order(zero, 3, reach) < 0);
}

// A term that counts zero times may be of any size.
void factor_zero(void **) {
  ExactSum difference[2], reach;
  difference[0].add(1.0, 1);
  difference[0].add(kTiniest, 0);
  difference[1].add(kLargest, 0);
  reach.add(1.0, 1);
  const int tie = exact_order(difference, 2, reach);
  reach.add(0x1p-52, 1);
  const int more = exact_order(difference, 2, reach);
  assert_int_equal(tie, 0);
  assert_int_equal(more, -1);
}

void compare_rounded(const char *what, const ExactSum &sum) {
  const double rounded = hg::round_exactly(sum);
  require(is_rounded(rational(sum), rounded), "%s: %a is not the sum rounded", what, rounded);
}

void rounds_any_numbers(void **) {
  assert_true(sweep(20000, [](uint64_t seed) {
    Rng rng(seed);
    compare_rounded("any numbers", any_sum(rng));
  }));
}

// What is left of large terms, at every distance below and every place of the last bit; and the middle between two
// doubles, with and without something below it.
void rounds_what_is_left(void **) {
  assert_true(sweep(20000, [](uint64_t seed) {
    Rng rng(seed);
    const int exponent = rng.integer(-700, 700);
    const double large = any_double(rng);
    const auto whole = static_cast<double>((uint64_t{1} << 52) + rng.below(4));
    ExactSum sum;
    sum.add(large, 1);
    sum.add(std::ldexp(whole, exponent), rng.chance(0.5) ? 1 : -1);
    sum.add(std::ldexp(1.0, exponent - 1), rng.integer(-1, 1));
    sum.add(std::ldexp(1.0, exponent - rng.integer(2, 150)), rng.integer(-1, 1));
    sum.add(large, -1);
    compare_rounded("what is left", sum);
  }));
}

void rounds_nothing_to_zero(void **) {
  ExactSum none, cancelled;
  cancelled.add(kLargest, 3);
  cancelled.add(kLargest, -3);
  const double zeros[] = {hg::round_exactly(none), hg::round_exactly(cancelled)};
  for (const double zero : zeros) assert_true(zero == 0 && !std::signbit(zero));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(any_numbers),
      cmocka_unit_test(similar_numbers),
      cmocka_unit_test(ties),
      cmocka_unit_test(near_ties),
      cmocka_unit_test(longest_integers),
      cmocka_unit_test(nothing_is_less_than_zero),
      cmocka_unit_test(factor_zero),
      cmocka_unit_test(rounds_any_numbers),
      cmocka_unit_test(rounds_what_is_left),
      cmocka_unit_test(rounds_nothing_to_zero),
  };
  return cmocka_run_group_tests_name("exact_sign", tests, nullptr, nullptr);
}
