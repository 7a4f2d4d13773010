// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Folds over many numbers against plain loops.
#include "src/base/reductions.hpp"
#include "tests/unit/checks.hpp"

#include <algorithm>
#include <vector>

namespace {

using namespace hgtest;

void check_folds(uint64_t seed) {
  Rng rng(seed);
  std::vector<double> values(rng.below(100));
  for (double &v : values) v = static_cast<double>(rng.below(20));
  const double limit = static_cast<double>(rng.below(22)) - 1;
  const hg::Within within = hg::within(values.data(), values.size(), limit, -2);
  size_t count = 0;
  double greatest = -2, sum = 0;
  for (double v : values) {
    sum += v;
    if (v > limit) continue;
    count++;
    greatest = std::max(greatest, v);
  }
  require(within.count == count && within.greatest == greatest, "%zu up to %g, the greatest %g", within.count, limit,
          within.greatest);
  require(hg::sum_of(values.data(), values.size()) == sum, "the sum of whole numbers is not %g", sum);
}

void folds(void **) { assert_true(sweep(500, check_folds)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(folds)};
  return cmocka_run_group_tests_name("reductions", tests, nullptr, nullptr);
}
