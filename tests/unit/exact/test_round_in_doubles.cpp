// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// round_in_doubles() against rational numbers: what it is sure of is right, and it is sure of nearly everything that
// particles across a periodic face bring.
#include "src/exact/round_in_doubles.hpp"
#include "tests/support/rounded.hpp"
#include "tests/unit/checks.hpp"

#include <cmath>
#include <limits>

namespace {

using namespace hgtest;
using hg::ExactSum;

mpq_class rational(const ExactSum &sum) {
  mpq_class total = 0;
  for (int k = 0; k < sum.count; k++) {
    total += mpq_class(sum.terms[k].value) * mpq_class(static_cast<double>(sum.terms[k].factor));
  }
  return total;
}

// Whether it is sure; throws if it is so without reason.
bool is_sure(const ExactSum &sum) {
  double rounded = 0;
  if (!hg::round_in_doubles(sum, rounded)) return false;
  require(is_rounded(rational(sum), rounded), "%a is not the sum rounded", rounded);
  return true;
}

// As many terms as there are, with factors up to 2^27, around any exponent that doubles have.
void any_numbers(void **) {
  assert_true(sweep(20000, [](uint64_t seed) {
    Rng rng(seed);
    ExactSum sum;
    const int terms = rng.integer(1, hg::kMaxExactTerms), exponent = rng.integer(-1060, 1000),
              spread = rng.integer(0, 99);
    for (int k = 0; k < terms; k++) {
      const double size = std::ldexp(1 + rng.uniform(), exponent + rng.integer(-spread, spread) / 2);
      const int64_t factor = int64_t{1} << rng.integer(0, 27);
      sum.add(rng.chance(0.5) ? size : -size, factor - rng.integer(0, 1));
    }
    is_sure(sum);
  }));
}

// The middle between two doubles, and less than it can tell beside it; large terms that cancel.
void middles(void **) {
  assert_true(sweep(20000, [](uint64_t seed) {
    Rng rng(seed);
    const int exponent = rng.integer(-900, 700);
    const auto whole = static_cast<double>((uint64_t{1} << 52) + rng.below(4));
    const double large = std::ldexp(1 + rng.uniform(), exponent + rng.integer(0, 120));
    ExactSum sum;
    sum.add(large, 3);
    sum.add(std::ldexp(whole, exponent), 1);
    sum.add(std::ldexp(1.0, exponent - 1), rng.integer(-1, 1));
    sum.add(std::ldexp(1.0, exponent - rng.integer(2, 150)), rng.integer(-1, 1));
    sum.add(large, -3);
    is_sure(sum);
  }));
}

// The middle is rounded to even, if nothing is lost; else it is left to others, as are numbers that are too large.
void the_middle_itself(void **) {
  ExactSum middle, beside, too_large;
  middle.add(1.0, 1);
  middle.add(0x1p-53, 1);
  beside.add(1.0, 1);
  beside.add(0x1p-53, 1);
  beside.add(0x1p-110, 1);
  too_large.add(std::numeric_limits<double>::max(), 1);
  too_large.add(std::numeric_limits<double>::max(), -1);
  double rounded = 0;
  assert_true(hg::round_in_doubles(middle, rounded));
  assert_true(rounded == 1);
  assert_false(hg::round_in_doubles(beside, rounded));
  assert_false(hg::round_in_doubles(too_large, rounded));
}

// x_b - x_a + n (high - low) + tilt, with places in a box or some boxes away.
void nearly_always_sure(void **) {
  int sure = 0;
  constexpr int kTimes = 20000;
  assert_true(sweep(kTimes, [&](uint64_t seed) {
    Rng rng(seed);
    const double low = rng.uniform(-10, 10), length = rng.uniform(1, 10);
    ExactSum sum;
    sum.add(low + length * rng.uniform(), 1);
    sum.add(low + length * rng.uniform(), -1);
    const int n = rng.integer(-3, 3);
    sum.add(low + length, n);
    sum.add(low, -n);
    sum.add(rng.uniform(-1, 1), rng.integer(-2, 2));
    sure += is_sure(sum) ? 1 : 0;
  }));
  assert_true(sure > kTimes - kTimes / 1000);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_numbers), cmocka_unit_test(middles),
                              cmocka_unit_test(the_middle_itself), cmocka_unit_test(nearly_always_sure)};
  return cmocka_run_group_tests_name("round_in_doubles", tests, nullptr, nullptr);
}
