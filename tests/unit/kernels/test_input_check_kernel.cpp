// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The input-check kernels of every instruction set that this machine runs against plain loops: extremes, copies, and
// one number that is not finite anywhere.
#include "tests/unit/checks.hpp"
#include "tests/unit/kernels/kernel_sets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace hgtest;

constexpr double kGuard = -77;

double any_number(Rng &rng) {
  static constexpr double kHard[] = {0.0, -0.0, 5e-324, -5e-324, 1.7976931348623157e308, -1.7976931348623157e308};
  if (rng.chance(0.1)) return kHard[rng.below(6)];
  return std::ldexp(rng.uniform(-1, 1), rng.integer(-1074, 1023));
}

struct Input {
  Input(uint64_t seed, size_t particles) : rng(seed), dimension(rng.integer(2, 3)), count(particles) {
    centers.resize(count * static_cast<size_t>(dimension));
    radii.resize(count);
    for (double &x : centers) x = any_number(rng);
    for (double &r : radii) r = any_number(rng);
  }

  hg::InputSummary look(const hg::KernelSet &set, const double *given_radii) const {
    return set.check_input[dimension - 2]({count, centers.data(), given_radii, nullptr, nullptr});
  }

  Rng rng;
  int dimension;
  size_t count;
  std::vector<double> centers, radii;
};

// Every value of a column, `stride` apart.
void require_extremes(const char *set, const hg::Interval &found, const std::vector<double> &values, size_t first,
                      size_t stride) {
  double least = values[first], greatest = values[first];
  for (size_t i = first; i < values.size(); i += stride) {
    least = std::min(least, values[i]);
    greatest = std::max(greatest, values[i]);
  }
  require(found.least == least && found.greatest == greatest, "%s: [%a, %a] instead of [%a, %a]", set, found.least,
          found.greatest, least, greatest);
}

void require_summary(const char *set, const hg::InputSummary &found, const Input &input, bool with_radii) {
  require(found.finite, "%s: finite numbers are not", set);
  const auto dimension = static_cast<size_t>(input.dimension);
  for (size_t axis = 0; axis < dimension; axis++) {
    require_extremes(set, found.center[axis], input.centers, axis, dimension);
  }
  if (with_radii) require_extremes(set, found.radius, input.radii, 0, 1);
}

// Copies hold the same bits, and nothing behind them is written.
void require_copy(const char *set, const std::vector<double> &copy, const std::vector<double> &from) {
  require(std::memcmp(copy.data(), from.data(), from.size() * sizeof(double)) == 0, "%s: another copy", set);
  require(
      std::all_of(copy.begin() + static_cast<ptrdiff_t>(from.size()), copy.end(), [](double x) { return x == kGuard; }),
      "%s: wrote behind the copy", set);
}

void check_numbers(uint64_t seed, size_t count) {
  const Input input(seed, count);
  for (const hg::KernelSet *set : kernel_sets()) {
    std::vector<double> centers(input.centers.size() + 8, kGuard), radii(input.radii.size() + 8, kGuard);
    hg::InputCheckKernel *kernel = set->check_input[input.dimension - 2];
    require_summary(set->name, kernel({count, input.centers.data(), input.radii.data(), centers.data(), radii.data()}),
                    input, true);
    require_copy(set->name, centers, input.centers);
    require_copy(set->name, radii, input.radii);
    require_summary(set->name, input.look(*set, input.radii.data()), input, true);
    require_summary(set->name, input.look(*set, nullptr), input, false);
  }
}

// Wherever the one number stands, and whatever stands beside it.
void check_not_finite(uint64_t seed, size_t count) {
  Input input(seed, count);
  static constexpr double kBad[] = {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL};
  const bool in_radii = input.rng.chance(0.3);
  std::vector<double> &values = in_radii ? input.radii : input.centers;
  double &value = values[input.rng.below(values.size())];
  value = kBad[input.rng.below(3)];
  for (const hg::KernelSet *set : kernel_sets()) {
    require(!input.look(*set, input.radii.data()).finite, "%s: %g counts as finite", set->name, value);
    require(input.look(*set, nullptr).finite == in_radii, "%s: radii that are not given are looked at", set->name);
  }
}

// All numbers of particles around one vector, and any up to a few chunks.
void numbers(void **) {
  assert_true(sweep(60, [](uint64_t seed) { check_numbers(seed, 1 + seed); }));
  assert_true(sweep(200, [](uint64_t seed) { check_numbers(seed, 1 + Rng(seed).below(3000)); }));
}
void not_finite(void **) {
  assert_true(sweep(1000, [](uint64_t seed) { check_not_finite(seed, 1 + seed % 70); }));
  assert_true(sweep(1000, [](uint64_t seed) { check_not_finite(seed, 1 + Rng(seed).below(2000)); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(numbers), cmocka_unit_test(not_finite)};
  return cmocka_run_group_tests_name("input_check_kernel", tests, nullptr, nullptr);
}
