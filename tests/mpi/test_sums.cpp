// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Sums that must not depend on the order of their terms: against long numbers, and in any order.
#include "dem_mpi/exact_sum.hpp"
#include "dem_mpi/push_sums.hpp"
#include "tests/support/frame.h"

#include <gmpxx.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <random>
#include <vector>

namespace {

using dem::ranks::ExactSum;
using dem::ranks::PushSums;

double sum_of(const std::vector<double> &terms) {
  ExactSum sum;
  for (const double term : terms) sum.add(term);
  return sum.value();
}

// As a fraction without any rounding; what a double then loses is below a unit in its last place.
void sums_are_those_of_long_numbers(void **) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> digits(-1, 1);
  std::uniform_int_distribution<int> exponent(-1070, 1000), small(-60, 60);
  for (int round = 0; round < 200; round++) {
    std::vector<double> terms;
    mpq_class truth = 0;
    for (int k = 0; k < 40; k++) {
      terms.push_back(std::ldexp(digits(random), round % 2 == 0 ? small(random) : exponent(random)));
      if (k % 3 == 0) terms.push_back(-terms[terms.size() / 2]);
    }
    for (const double term : terms) truth += mpq_class(term);
    const double sum = sum_of(terms);
    assert_true(abs(mpq_class(sum) - truth) <= mpq_class(DBL_EPSILON) * abs(truth) + mpq_class(DBL_TRUE_MIN));
    std::shuffle(terms.begin(), terms.end(), random);
    assert_true(sum_of(terms) == sum);
  }
}

void what_cancels_leaves_the_rest(void **) {
  assert_true(sum_of({1e300, 1, 1e-300, -1e300, -1}) == 1e-300);
  assert_true(sum_of({DBL_TRUE_MIN, -1e308, 1e308}) == DBL_TRUE_MIN);
  assert_true(sum_of({-DBL_TRUE_MIN, -1.5}) == -1.5);
  assert_true(sum_of({}) == 0 && sum_of({3, -3}) == 0);
  assert_true(std::isnan(sum_of({1, HUGE_VAL, -HUGE_VAL})));
}

// A part on each rank, added limb by limb.
void parts_add_up(void **) {
  std::vector<double> terms;
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  ExactSum parts[3], whole;
  for (int k = 0; k < 3000; k++) {
    const double term = std::exp(20 * normal(random)) * normal(random);
    parts[k % 3].add(term);
    whole.add(term);
  }
  ExactSum sum;
  for (const ExactSum &part : parts) {
    for (size_t k = 0; k < ExactSum::kWidth; k++) sum.limbs()[k] += part.limbs()[k];
  }
  assert_true(sum.value() == whole.value() && std::isfinite(sum.value()));
}

struct Push {
  dem::Course<double> move{}, turn{};
};

std::vector<Push> some_pushes(size_t count, double largest) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<Push> pushes(count);
  for (Push &push : pushes) {
    const double size = largest * std::exp2(-std::fabs(20 * normal(random)));
    for (int k = 0; k < 3; k++) {
      push.move.push.numbers[k] = size * normal(random);
      push.turn.push.numbers[k] = size * normal(random);
    }
  }
  return pushes;
}

Push total(const std::vector<Push> &pushes, PushSums &sums, bool *exact) {
  sums.clear(2);
  for (const Push &push : pushes) sums.add(1, push.move, &push.turn);
  Push result;
  *exact = sums.give(1, result.move, &result.turn);
  return result;
}

void pushes_add_up_in_any_order(void **) {
  PushSums sums(300, 0.7, true);
  assert_int_equal(sums.columns(), 16);
  std::vector<Push> pushes = some_pushes(20000, 300);
  bool exact = false;
  const Push first = total(pushes, sums, &exact);
  assert_true(exact);
  for (int k = 0; k < 3; k++) {
    ExactSum truth;
    for (const Push &push : pushes) truth.add(push.move.push.numbers[k]);
    // 2^-70 of the deepest force for each of them, and one rounding in the end.
    assert_true(std::fabs(first.move.push.numbers[k] - truth.value()) <=
                20000 * 512 * 0x1p-71 + std::fabs(truth.value()) * DBL_EPSILON);
  }
  std::mt19937_64 random(4);
  for (int round = 0; round < 20; round++) {
    std::shuffle(pushes.begin(), pushes.end(), random);
    const Push again = total(pushes, sums, &exact);
    for (int k = 0; k < 3; k++) {
      assert_true(again.move.push.numbers[k] == first.move.push.numbers[k]);
      assert_true(again.turn.push.numbers[k] == first.turn.push.numbers[k]);
    }
  }
}

void sums_that_are_not_exact_are_known(void **) {
  PushSums sums(1, 1, true);
  bool exact = false;
  total(some_pushes(10, 1e3), sums, &exact);
  assert_true(exact);
  total(some_pushes(10, 1e8), sums, &exact);
  assert_false(exact);
  total(some_pushes(40000, 1), sums, &exact);  // too many for the rests
  assert_false(exact);
  std::vector<Push> none = some_pushes(3, 1);
  none[1].move.push.numbers[2] = std::nan("");
  total(none, sums, &exact);
  assert_false(exact);
}

}  // namespace

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(sums_are_those_of_long_numbers),
      cmocka_unit_test(what_cancels_leaves_the_rest),
      cmocka_unit_test(parts_add_up),
      cmocka_unit_test(pushes_add_up_in_any_order),
      cmocka_unit_test(sums_that_are_not_exact_are_known),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
