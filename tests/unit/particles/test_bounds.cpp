// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The extents of what is stored.
#include "src/particles/bounds.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/domains.hpp"
#include "tests/unit/stores.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace hgtest;
using hg::Domain;

void check_bounds(uint64_t) {
  hg::Memory memory(hg::system_allocator());
  Domain domain;
  set_box(domain, 1, -5, 5);
  hg::ParticleStore store = make_store(memory, domain);
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

// Many particles are looked at in parts; any number of threads finds the same bounds, whichever part holds the farthest
// and largest.
constexpr uint64_t kPlaces = 16;
void check_threads(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  Domain domain;
  hg::ParticleStore store = make_store(memory, domain), shared = make_store(memory, domain, {}, 0, HUGE_VAL, 4);
  const size_t count = rng.chance(0.2) ? rng.below(3) : 100000 + rng.below(1000);
  std::vector<double> centers(3 * count), radii(count);
  for (double &x : centers) x = rng.uniform(-1, 1);
  for (double &r : radii) r = rng.uniform();
  if (count > 0) {
    const size_t far = count * seed / kPlaces;
    std::fill_n(centers.begin() + static_cast<ptrdiff_t>(3 * far), 3, seed % 2 == 0 ? 2.0 : -2.0);
    radii[far] = 2;
  }
  store.insert(count, centers.data(), radii.data());
  shared.insert(count, centers.data(), radii.data());
  const hg::Bounds one = hg::bounds_of(store, domain, 1), four = hg::bounds_of(shared, domain, 4);
  for (size_t axis = 0; count > 0 && axis < 3; axis++) {
    double least = centers[axis], greatest = least;
    for (size_t i = axis; i < 3 * count; i += 3) {
      least = std::min(least, centers[i]);
      greatest = std::max(greatest, centers[i]);
    }
    for (const hg::Bounds *found : {&one, &four}) {
      require(found->min[axis] == least && found->max[axis] == greatest, "axis %zu: [%a, %a] instead of [%a, %a]", axis,
              found->min[axis], found->max[axis], least, greatest);
    }
    require(one.width[axis] == four.width[axis], "axis %zu: width %a instead of %a", axis, four.width[axis],
            one.width[axis]);
  }
  const double largest = count > 0 ? 2 : 0;
  require(one.max_radius == largest && four.max_radius == largest, "largest radius %a", four.max_radius);
}

void threads(void **) { assert_true(sweep(kPlaces, check_threads)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(bounds), cmocka_unit_test(threads)};
  return cmocka_run_group_tests_name("bounds", tests, nullptr, nullptr);
}
