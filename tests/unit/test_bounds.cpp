// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The extents of what is stored, and the folds over many numbers that find them.
#include "src/base/reductions.hpp"
#include "src/space/bounds.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/stores.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace hgtest;
using hg::Domain;

template <size_t Columns>
void check_columns(Rng &rng) {
  std::vector<double> values(Columns * (1 + rng.below(100)));
  for (double &v : values) v = rng.uniform(-1, 1) * std::pow(10, rng.integer(-300, 300));
  hg::Interval found[Columns];
  hg::column_extremes<Columns>(values.data(), values.size() / Columns, found);
  for (size_t k = 0; k < Columns; k++) {
    double least = values[k], greatest = values[k];
    for (size_t i = k; i < values.size(); i += Columns) {
      least = std::min(least, values[i]);
      greatest = std::max(greatest, values[i]);
    }
    require(found[k].least == least && found[k].greatest == greatest, "column %zu of %zu: [%g, %g]", k, Columns,
            found[k].least, found[k].greatest);
  }
}

void check_folds(uint64_t seed) {
  Rng rng(seed);
  check_columns<1>(rng);
  check_columns<2>(rng);
  check_columns<3>(rng);

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

void check_bounds(uint64_t) {
  hg::Memory memory(hg::system_allocator());
  Domain domain;
  domain.periodic[1] = domain.any_periodic = true;
  domain.box_min[1] = -5;
  domain.box_max[1] = 5;
  domain.length[1] = 10;
  hg::ParticleStore store = make_store(memory, domain, hg::Interaction{}, 0, HUGE_VAL);
  const double x[15] = {1, 1, 1, 2, 2, -9, 3, 3, 3, 4, 4, 7, -8, 5, 5}, r[5] = {0.5, 1, 2, 0, 1.5};
  store.insert(5, x, r);
  const hg::Bounds bounds = hg::bounds_of(store, domain, 1);
  require(bounds.min[0] == -8 && bounds.max[0] == 4, "x in [%g, %g]", bounds.min[0], bounds.max[0]);
  require(bounds.min[1] == 0 && bounds.max[1] == 10, "y in [%g, %g]", bounds.min[1], bounds.max[1]);
  require(bounds.min[2] == -9 && bounds.max[2] == 7, "z in [%g, %g]", bounds.min[2], bounds.max[2]);
  require(bounds.max_radius == 2 && bounds.width[1] == 10, "largest radius %g", bounds.max_radius);
  require(bounds.width[0] >= 12 && bounds.width[2] >= 16, "widths %g, %g", bounds.width[0], bounds.width[2]);
}

void bounds(void **) { assert_true(holds(0, check_bounds)); }

// Many particles are looked at in parts; any number of threads finds the same bounds.
void check_threads(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  Domain domain;
  hg::ParticleStore store = make_store(memory, domain, hg::Interaction{}, 0, HUGE_VAL);
  const size_t count = rng.chance(0.2) ? rng.below(3) : 100000 + rng.below(1000);
  std::vector<double> centers(3 * count), radii(count);
  for (double &x : centers) x = rng.uniform(-1, 1);
  for (double &r : radii) r = rng.uniform();
  store.insert(count, centers.data(), radii.data());
  const hg::Bounds one = hg::bounds_of(store, domain, 1), four = hg::bounds_of(store, domain, 4);
  for (int k = 0; count > 0 && k < 3; k++) {
    double least = centers[static_cast<size_t>(k)], greatest = least;
    for (size_t i = static_cast<size_t>(k); i < 3 * count; i += 3) {
      least = std::min(least, centers[i]);
      greatest = std::max(greatest, centers[i]);
    }
    require(one.min[k] == least && one.max[k] == greatest, "axis %d: [%a, %a]", k, one.min[k], one.max[k]);
    require(one.min[k] == four.min[k] && one.max[k] == four.max[k], "axis %d: [%a, %a]", k, four.min[k], four.max[k]);
    require(one.width[k] == four.width[k], "axis %d: width %a instead of %a", k, four.width[k], one.width[k]);
  }
  require(one.max_radius == four.max_radius, "largest radius %a", four.max_radius);
}

void threads(void **) { assert_true(sweep(5, check_threads)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(folds), cmocka_unit_test(bounds), cmocka_unit_test(threads)};
  return cmocka_run_group_tests_name("bounds", tests, nullptr, nullptr);
}
