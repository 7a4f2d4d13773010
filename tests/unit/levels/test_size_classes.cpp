// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// SizeClasses: classes ascend, hold every particle once and never part equal radii.
#include "src/levels/size_classes.hpp"
#include "tests/unit/checks.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace {

using namespace hgtest;
using hg::SizeClasses;

// What both ways to make classes promise, counted afresh from the radii.
void require_classes(const SizeClasses &classes, const std::vector<double> &radii) {
  int64_t before = 0;
  for (size_t c = 0; c < classes.count(); c++) {
    const double largest = classes.largest_radius(c);
    require(c == 0 || largest > classes.largest_radius(c - 1), "class %zu does not ascend", c);
    // All particles up to the largest radius of class c are in the classes 0 .. c: hence no equal radii apart.
    const int64_t upto = std::count_if(radii.begin(), radii.end(), [&](double r) { return r <= largest; });
    require(classes.particles(0, c) == upto, "classes 0 .. %zu hold %lld particles instead of %lld", c,
            static_cast<long long>(classes.particles(0, c)), static_cast<long long>(upto));
    require(classes.particles(c, c) == upto - before, "class %zu is off", c);
    before = upto;
  }
  require(before == static_cast<int64_t>(radii.size()), "%lld of %zu particles are in a class",
          static_cast<long long>(before), radii.size());
  if (radii.empty()) return;
  const double greatest = *std::max_element(radii.begin(), radii.end());
  require(classes.largest_radius(classes.count() - 1) == greatest, "the last class ends above all radii");
}

hg::Interval extremes_of(const std::vector<double> &radii) {
  if (radii.empty()) return {0, 0};
  const auto [least, greatest] = std::minmax_element(radii.begin(), radii.end());
  return {*least, *greatest};
}

void bin(SizeClasses &classes, const std::vector<double> &radii) {
  classes.bin_radii(radii.data(), radii.size(), extremes_of(radii));
}

void sort(SizeClasses &classes, const std::vector<double> &radii) {
  classes.sort_radii(radii.data(), radii.size(), extremes_of(radii));
}

std::vector<double> any_radii(Rng &rng) {
  std::vector<double> radii(rng.below(3000));
  const int kind = rng.integer(0, 4);
  for (double &r : radii) {
    switch (kind) {
      case 0:
        r = rng.uniform(1, 2);
        break;
      case 1:
        r = static_cast<double>(rng.below(50));
        break;
      case 2:
        r = std::ldexp(1 + rng.uniform(), rng.integer(-1074, 1022));
        break;
      case 3:
        r = rng.chance(0.5) ? 0.0 : -0.0;
        break;
      default:
        r = 1 + static_cast<double>(rng.below(3)) * 0x1p-52;
        break;
    }
  }
  return radii;
}

void check_any(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  SizeClasses sorted(memory), binned(memory);
  for (int pass = 0; pass < 2; pass++) {
    const std::vector<double> radii = any_radii(rng);
    sort(sorted, radii);
    require_classes(sorted, radii);
    require(sorted.count() == std::set<double>(radii.begin(), radii.end()).size(), "a class for each distinct radius");
    bin(binned, radii);
    require_classes(binned, radii);
    require(binned.count() <= SizeClasses::kBins, "%zu bins", binned.count());
  }
}

// Bins must be narrow: over one octave, neighbouring radii in a bin differ by less than 2 parts in kBins.
void check_resolution(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  SizeClasses classes(memory);
  std::vector<double> radii(20000);
  for (double &r : radii) r = rng.uniform(1, 2);
  std::sort(radii.begin(), radii.end());
  bin(classes, radii);
  size_t first = 0;
  for (size_t c = 0; c < classes.count(); c++) {
    const double ratio = classes.largest_radius(c) / radii[first];
    require(ratio < 1 + 2.0 / SizeClasses::kBins, "bin %zu spans a ratio of %g", c, ratio);
    first = static_cast<size_t>(classes.particles(0, c));
  }
}

void any_radii_in_classes(void **) { assert_true(sweep(60, check_any)); }
void bins_are_narrow(void **) { assert_true(sweep(3, check_resolution)); }

void ratio_1e300(void **) {
  assert_true(holds(0, [](uint64_t) {
    hg::Memory memory(hg::system_allocator());
    SizeClasses classes(memory);
    const std::vector<double> radii = {1e150, 1e-150, 1, 1e-150, 0, 5e-324, 1.7e308};
    bin(classes, radii);
    require_classes(classes, radii);
    require(classes.count() >= 4, "only %zu classes", classes.count());
  }));
}

void no_particles(void **) {
  assert_true(holds(0, [](uint64_t) {
    hg::Memory memory(hg::system_allocator());
    SizeClasses classes(memory);
    sort(classes, {1});
    sort(classes, {});
    require(classes.count() == 0, "sorted: %zu classes", classes.count());
    bin(classes, {1});
    bin(classes, {});
    require(classes.count() == 0, "binned: %zu classes", classes.count());
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(any_radii_in_classes),
      cmocka_unit_test(bins_are_narrow),
      cmocka_unit_test(ratio_1e300),
      cmocka_unit_test(no_particles),
  };
  return cmocka_run_group_tests_name("size_classes", tests, nullptr, nullptr);
}
