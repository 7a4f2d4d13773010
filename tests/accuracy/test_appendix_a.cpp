// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Appendix A against values computed by an independent program for the paper's systems, against the continuum limit,
// and against the library.
#include "packing/packing.hpp"
#include "packing/size_law.hpp"
#include "particles/insert.hpp"
#include "programs/accuracy/search/appendix_a.hpp"
#include "programs/measure/search_timer.hpp"
#include "tests/support/frame.h"

#include <cmath>
#include <cstdio>

namespace {

using packing::Law;
using packing::SizeLaw;

constexpr double kDensity = 0.62;

// The paper's 125001 particles, systematic sampling with u = 0.5.
accuracy::Sizes sizes_of(const SizeLaw &law, size_t count = 125001) {
  accuracy::Sizes sizes;
  sizes.radii = packing::sample_radii(law, count, 0.5);
  sizes.edge = packing::box_edge(sizes.radii, kDensity, 3);
  return sizes;
}

bool near(double found, double expected, double relative) {
  if (std::fabs(found - expected) <= relative * expected) return true;
  std::printf("found %.9g, expected %.9g\n", found, expected);
  return false;
}

bool least_m_is(const SizeLaw &law, const std::vector<double> &expected) {
  const accuracy::Sizes sizes = sizes_of(law);
  for (size_t levels = 1; levels <= expected.size(); levels++) {
    if (!near(accuracy::least_m(sizes, levels), expected[levels - 1], 3e-6)) return false;
  }
  return true;
}

bool bisection_gives_the_reference_values() {
  return least_m_is({Law::kUniformVolume, 50, 3}, {1487.405412, 13.286065, 2.745570, 1.205023, 0.713949, 0.488022,
                                                   0.367057, 0.291491, 0.239180, 0.203122}) &&
         least_m_is({Law::kUniformSize, 50, 3}, {4.641668, 1.290519, 0.687704, 0.457637, 0.339660});
}

bool the_cheapest_levels_are_the_references() {
  const accuracy::Choice volume = accuracy::cheapest_by_bisection(sizes_of({Law::kUniformVolume, 50, 3}), 0.3);
  const accuracy::Choice size = accuracy::cheapest_by_bisection(sizes_of({Law::kUniformSize, 50, 3}), 0.3);
  const accuracy::Choice two = accuracy::cheapest_by_bisection(sizes_of({Law::kTwoSizes, 10, 3}), 0.3);
  const accuracy::Choice one = accuracy::cheapest_by_bisection(sizes_of({Law::kMono, 1, 3}), 0.3);
  // Equal spheres: 6 nu / pi in each cell.
  return volume.ends.size() == 7 && near(volume.cost, 4.6694, 2e-5) && size.ends.size() == 3 &&
         near(size.cost, 2.9631, 2e-5) && two.ends.size() == 2 && near(two.cost, 1.785, 3e-4) && one.ends.size() == 1 &&
         near(one.cost, 6 * kDensity / 3.14159265358979 + 0.3, 1e-9);
}

// The levels of uniform volume, ratio 50: counts and the largest radius on each.
bool levels_are_those_of_the_reference() {
  const accuracy::Sizes sizes = sizes_of({Law::kUniformVolume, 50, 3});
  const accuracy::LevelEnds ends = accuracy::levels_for(sizes, accuracy::least_m(sizes, 7), 7);
  const std::vector<size_t> counts = {113043, 9676, 1623, 421, 146, 62, 30};
  const std::vector<double> cells = {6.4540, 14.6440, 26.5516, 41.6376, 59.2427, 78.8171, 99.5039};
  if (ends.size() != counts.size()) return false;
  const std::vector<double> edges = accuracy::edges_of(sizes, ends);
  size_t begin = 0;
  for (size_t level = 0; level < ends.size(); level++) {
    if (ends[level] - begin != counts[level] || !near(2 * edges[level], cells[level], 1e-5)) return false;
    begin = ends[level];
  }
  return begin == sizes.radii.size();
}

// On the grid the least m is that of bisection rounded up, so the levels can be told in advance.
bool grid_rounds_up(const SizeLaw &law, size_t levels_expected) {
  const accuracy::Sizes sizes = sizes_of(law, 20000);
  for (const double step : {1e-3, 1e-2}) {
    const accuracy::Choice found = accuracy::cheapest_on_grid(sizes, 0.3, step);
    double least = HUGE_VAL;
    size_t fewest = 0;
    for (size_t levels = 1; levels <= 12; levels++) {
      const double m = std::ceil(accuracy::least_m(sizes, levels) / step) * step;
      const accuracy::LevelEnds ends = accuracy::levels_for(sizes, m, 64);
      const double cost = static_cast<double>(ends.size()) * (accuracy::occupancy_of(sizes, ends) + 0.3);
      if (cost < least) fewest = ends.size();
      least = std::min(least, cost);
    }
    if (!near(found.cost, least, 1e-12) || found.ends.size() != fewest || fewest != levels_expected) return false;
  }
  return true;
}

bool the_grid_is_bisection_rounded_up() {
  return grid_rounds_up({Law::kUniformVolume, 50, 3}, 7) &&
         grid_rounds_up({Law::kUniformSize, 1.1, 3}, 1);  // the last on the grid
}

// Levels chosen for all cost what they should; those for every second radius, the largest among them, a little more.
bool a_sample_costs_a_little_more() {
  const accuracy::Sizes sizes = sizes_of({Law::kUniformVolume, 20, 3}, 4000);
  const accuracy::Choice exact = accuracy::cheapest_by_bisection(sizes, 0.3);
  const double again = accuracy::cost_of_edges(sizes, accuracy::edges_of(sizes, exact.ends), 0.3);
  accuracy::Sizes half = sizes;
  half.weight = 2;
  half.radii.clear();
  for (size_t i = 1; i < sizes.radii.size(); i += 2) half.radii.push_back(sizes.radii[i]);
  const accuracy::Choice guess = accuracy::cheapest_by_bisection(half, 0.3);
  const double excess = accuracy::cost_of_edges(sizes, accuracy::edges_of(half, guess.ends), 0.3) / exact.cost - 1;
  std::printf("cost above the least: %g\n", excess);
  return again == exact.cost && excess > 0 && excess < 0.1;
}

// The library's own bisection, through its public interface.
bool the_library_finds_the_same() {
  packing::Request request;
  request.law = {Law::kUniformVolume, 20, 3};
  request.count = 5000;
  request.sweeps = 0;
  const particles::ParticleSet particles = packing::make_packing(request, nullptr).particles;
  hg_grid_def def = measure::def_of(particles);
  def.level_rule = HG_LEVELS_PAPER;
  hgrid::Grid grid(def);
  particles::insert(particles, grid);
  const accuracy::Sizes sizes = sizes_of(request.law, request.count);
  for (const hg_level_cost &cost : grid.query_level_costs()) {
    if (cost.reachable == 0) continue;
    const auto levels = static_cast<size_t>(cost.level_count);
    const accuracy::LevelEnds ends = accuracy::levels_for(sizes, accuracy::least_m(sizes, levels), levels);
    if (!near(accuracy::occupancy_of(sizes, ends), cost.occupancy, 1e-9)) return false;
  }
  return grid.query_level_costs().size() > 3;
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(passes<bisection_gives_the_reference_values>),
                              cmocka_unit_test(passes<the_cheapest_levels_are_the_references>),
                              cmocka_unit_test(passes<levels_are_those_of_the_reference>),
                              cmocka_unit_test(passes<the_grid_is_bisection_rounded_up>),
                              cmocka_unit_test(passes<a_sample_costs_a_little_more>),
                              cmocka_unit_test(passes<the_library_finds_the_same>)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
