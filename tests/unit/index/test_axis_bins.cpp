// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Bins along an axis against positions sorted one by one: bins are in order, no longer than asked for, and know what
// they hold. From all positions in one bin to as many bins as positions, and axes used again for more or fewer.
#include "src/base/ordered_bits.hpp"
#include "src/index/axis_bins.hpp"
#include "tests/unit/checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace hgtest;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double any_position(Rng &rng, double spread) {
  if (rng.chance(0.01)) return rng.uniform(-1, 1) * std::numeric_limits<double>::max();
  if (rng.chance(0.01)) return rng.chance(0.5) ? 0.0 : -0.0;
  if (rng.chance(0.01)) return rng.chance(0.5) ? 5e-324 : -5e-324;
  return spread * rng.uniform(-1, 1);
}

void check_axis(Rng &rng, hg::AxisBins &bins) {
  const double width = std::pow(10, rng.chance(0.3) ? rng.uniform(-320, 290) : rng.uniform(-3, 3));
  const double spread = std::min(width * std::pow(10, rng.uniform(-1, 20)), 1e308);
  std::vector<double> x(rng.below(rng.chance(0.2) ? 6000 : 300));
  for (double &position : x) position = any_position(rng, spread);
  bins.begin(width, x.size());
  for (size_t at = 0; at < x.size();) {
    const size_t here = std::min(x.size() - at, 1 + rng.below(hg::AxisBins::kTogether));
    bins.add(at, x.data() + at, here);
    at += here;
  }
  bins.sort();

  std::vector<double> least(bins.count(), kInfinity), greatest(bins.count(), -kInfinity);
  for (size_t i = 0; i < x.size(); i++) {
    const uint32_t bin = bins.bin_of(i);
    require(bin < bins.count(), "position %zu is in bin %u of %zu", i, bin, bins.count());
    least[bin] = std::min(least[bin], x[i]);
    greatest[bin] = std::max(greatest[bin], x[i]);
  }
  double before = -kInfinity;
  std::vector<int> seen(bins.count(), 0);
  for (size_t at = 0; at < bins.count(); at++) {
    const uint32_t bin = bins.sorted(at);
    require(bin < bins.count() && seen[bin]++ == 0, "bin %u is there twice or not", bin);
    require(bins.least(bin) == least[bin] && bins.greatest(bin) == greatest[bin], "bin from %a to %a instead of %a, %a",
            bins.least(bin), bins.greatest(bin), least[bin], greatest[bin]);
    require(least[bin] >= before, "a bin from %a after %a", least[bin], before);
    require(0.5 * greatest[bin] - 0.5 * least[bin] <= 0.5 * width, "a bin from %a to %a is longer than %a", least[bin],
            greatest[bin], width);
    before = greatest[bin];
  }
}

void bins_of_positions(void **) {
  assert_true(sweep(60, [](uint64_t seed) {
    Rng rng(seed);
    hg::Memory memory(hg::system_allocator());
    hg::AxisBins bins(memory);
    for (int n = 0; n < 4; n++) check_axis(rng, bins);
  }));
}

// Where many positions are near each other, bins are few.
void few_bins(void **) {
  hg::Memory memory(hg::system_allocator());
  hg::AxisBins bins(memory);
  Rng rng(1);
  std::vector<double> x(1000);
  for (double &position : x) position = 5 * rng.uniform(-1, 1);
  bins.begin(1, x.size());
  for (size_t i = 0; i < x.size(); i++) bins.add(i, &x[i], 1);
  assert_in_range(bins.count(), 10, 20);
}

// Positions that the first hash would put into one place: searched one by one, they take longer than a test may.
void positions_that_meet(void **) {
  constexpr uint64_t kSpread = 0x9e3779b97f4a7c15u;
  uint64_t inverse = 1;
  for (int n = 0; n < 6; n++) inverse *= 2 - kSpread * inverse;  // modulo 2^64, by Newton's method
  std::vector<double> x;
  for (uint64_t hashed = 0; x.size() < size_t{1} << 20; hashed++) {
    const uint64_t mixed = hashed * inverse, bits = mixed ^ mixed >> 32;
    if (std::isfinite(hg::from_bits(bits))) x.push_back(hg::from_bits(bits));
  }
  hg::Memory memory(hg::system_allocator());
  hg::AxisBins bins(memory);
  bins.begin(1e-320, x.size());
  for (size_t i = 0; i < x.size(); i++) bins.add(i, &x[i], 1);
  assert_int_equal(bins.count(), x.size());
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(bins_of_positions), cmocka_unit_test(few_bins),
                              cmocka_unit_test(positions_that_meet)};
  return cmocka_run_group_tests_name("axis_bins", tests, nullptr, nullptr);
}
