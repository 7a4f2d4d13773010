// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The estimate of companions in a cell against a full count.
#include "src/levels/companions.hpp"
#include "src/space/level_cells.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/domains.hpp"
#include "tests/unit/stores.hpp"

#include <cmath>
#include <map>
#include <tuple>
#include <vector>

namespace {

using namespace hgtest;

// Particles in [0, 2^30)^3, clustered or not, of two sizes; only the larger are the level's.
void check_estimate(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  const hg::Domain domain = open_space(rng.integer(2, 3));
  hg::ParticleStore store = make_store(memory, domain);
  hg::FixedPoint map;
  for (int axis = 0; axis < domain.dimension; axis++) map.extent[axis] = 0x1p30;
  const size_t count = rng.chance(0.5) ? 2 + rng.below(1000) : 20000;
  const double spread = rng.chance(0.5) ? 0x1p30 : 0x1p26;
  std::vector<double> centers, radii;
  size_t larger = 0;
  for (size_t i = 0; i < count; i++) {
    for (int axis = 0; axis < domain.dimension; axis++) centers.push_back(spread * rng.uniform());
    radii.push_back(rng.chance(0.2) ? 1 : 2);
    larger += radii.back() == 2;
  }
  store.insert(count, centers.data(), radii.data());
  const hg::CellTable cells = hg::lay_cells(map, domain.dimension, 0x1p25, larger).table;

  std::map<std::tuple<int, int, int>, double> held;
  for (size_t slot = 0; slot < count; slot++) {
    if (radii[slot] != 2) continue;
    int cell[3] = {0, 0, 0};
    for (int axis = 0; axis < domain.dimension; axis++) {
      const double at = std::floor(store.center(slot)[axis]) * static_cast<double>(cells.inverse_width[axis]);
      cell[axis] = static_cast<int>(std::min(at, cells.count[axis] - 1.0));
    }
    held[{cell[0], cell[1], cell[2]}] += 1;
  }
  double others = 0;
  for (const auto &entry : held) others += entry.second * (entry.second - 1);
  const double expected = larger < 2 ? 0 : others / (static_cast<double>(larger) - 1);
  const double any = HUGE_VAL, estimate = estimate_companions(store, map, domain.dimension, cells, {1, 2}, larger, any);
  // Up to 4096 particles all are looked at, else so many that a few per cent are certain.
  const double tolerance = larger <= 4096 ? 0.1 + 0.1 * expected : 0.5 + 0.3 * expected;
  require(std::fabs(estimate - expected) < tolerance, "%zu particles: estimate %g, count %g", larger, estimate,
          expected);
  // Whether it is more than some number is the same when no more is asked.
  for (const double share : {0.0, 0.5, 0.99, 1.0, 1.01, 2.0}) {
    const double enough = share * estimate;
    const double at_least = estimate_companions(store, map, domain.dimension, cells, {1, 2}, larger, enough);
    require((at_least > enough) == (estimate > enough) && at_least <= estimate, "%g: %g instead of %g", enough,
            at_least, estimate);
  }
}

void estimates(void **) { assert_true(sweep(40, check_estimate)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(estimates)};
  return cmocka_run_group_tests_name("companions", tests, nullptr, nullptr);
}
