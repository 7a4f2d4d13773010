// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The level rule of Ogarko & Luding (2012), Appendix A and Eq. 7, against reference values.
//
// The occupancies m(L) below were computed by an independent program: N = 125001, systematic sampling, volume
// fraction 0.62, smallest m of any assignment with at most L levels.
#include "tests/support/compare.hpp"
#include "tests/support/rng.hpp"
#include "tests/support/size_laws.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

using namespace hgtest;

constexpr size_t kCount = 125001;
constexpr double kPi = 3.14159265358979323846;
constexpr double kOverhead = 0.3;  // K of Eq. 7

// The edge of the cube that the spheres fill to 0.62.
double box_edge(const std::vector<double> &radii) {
  double cubes = 0;
  for (double r : radii) cubes += r * r * r;
  return std::cbrt(4 * kPi / 3 * cubes / 0.62);
}

Grid filled_box(const std::vector<double> &radii, double edge, int32_t level_count) {
  Rng rng(1);
  hg_grid_def def = hg_default_grid_def();
  def.level_rule = HG_LEVELS_PAPER;
  def.level_count = level_count;
  Particles particles;
  for (double &b : def.box_max) b = edge;
  for (double r : radii) {
    const double x[3] = {rng.uniform(0, edge), rng.uniform(0, edge), rng.uniform(0, edge)};
    particles.add(x, r);
  }
  return make_grid(def, particles);
}

std::vector<hg_level_cost> costs_of(const Grid &grid) {
  const hgrid::View<hg_level_cost> costs = grid.query_level_costs();
  return std::vector<hg_level_cost>(costs.begin(), costs.end());
}

std::vector<hg_level> levels_of(const Grid &grid) {
  const hgrid::View<hg_level> levels = grid.query_levels();
  return std::vector<hg_level>(levels.begin(), levels.end());
}

void require_near(const std::string &what, double value, double expected, double tolerance) {
  require(std::fabs(value - expected) <= tolerance,
          what + ": " + std::to_string(value) + ", expected " + std::to_string(expected));
}

struct Reference {
  const char *name;
  InverseCdf *law;
  double omega;
  double edge;
  double occupancy[10];  // m(L), L = 1 .. 10
};

constexpr Reference kReferences[] = {
    {"uniform volume 50",
     uniform_volume,
     50,
     435.847842,
     {1487.405412, 13.286065, 2.745570, 1.205023, 0.713949, 0.488022, 0.367057, 0.291491, 0.239180, 0.203122}},
    {"uniform size 50",
     uniform_size,
     50,
     2997.4004,
     {4.641668, 1.290519, 0.687704, 0.457637, 0.339660, 0.268802, 0.221831, 0.188537, 0.163758, 0.144645}},
    {"uniform volume 10",
     uniform_volume,
     10,
     248.551222,
     {65.087539, 3.656849, 1.273102, 0.702347, 0.469865, 0.348350, 0.274954, 0.226318, 0.191798, 0.166229}},
    {"uniform volume 100",
     uniform_volume,
     100,
     550.905551,
     {5639.293858, 22.602109, 3.699347, 1.479259, 0.828275, 0.550407, 0.406026, 0.315798, 0.263050, 0.222726}}};

// m(L) to its printed digits and 1e-6, the cost by Eq. 7, and a choice whose cost is within 2 % of the best.
void check_reference(const Reference &reference) {
  const std::vector<double> radii = sample(reference.law, reference.omega, kCount);
  const double edge = box_edge(radii);
  require_near(std::string(reference.name) + " box edge", edge, reference.edge, 6e-5);
  const Grid grid = filled_box(radii, edge, 0);
  const std::vector<hg_level_cost> costs = costs_of(grid);
  require(costs.size() >= 10, std::string(reference.name) + ": fewer than 10 numbers of levels were looked at");
  double best = HUGE_VAL;
  for (int L = 1; L <= 10; L++) {
    const std::string what = std::string(reference.name) + " L = " + std::to_string(L);
    const double m = reference.occupancy[L - 1];
    const hg_level_cost &cost = costs[static_cast<size_t>(L - 1)];
    require(cost.level_count == L && cost.reachable == 1, what + " is not reachable");
    require_near(what + " m", cost.occupancy, m, 1e-6 * m + 5e-7);
    require_near(what + " cost", cost.cost, L * (m + kOverhead), 1e-6 * m * L + 5e-7 * L);
    best = std::min(best, L * (m + kOverhead));
  }
  const size_t chosen = levels_of(grid).size();
  require(chosen >= 1 && chosen <= costs.size(), "the chosen number of levels was not looked at");
  require(costs[chosen - 1].cost <= 1.02 * best, std::string(reference.name) + ": chose " + std::to_string(chosen));
}

void occupancies_and_costs(void **) {
  for (const Reference &reference : kReferences) {
    assert_true(holds(0, [&](uint64_t) { check_reference(reference); }));
  }
}

struct LevelReference {
  int64_t particle_count;
  double cell_size;
};

void require_levels(const std::vector<hg_level> &levels, const std::vector<LevelReference> &expected) {
  require(levels.size() == expected.size(), "wrong number of levels: " + std::to_string(levels.size()));
  for (size_t h = 0; h < levels.size(); h++) {
    const std::string what = "level " + std::to_string(h);
    require_near(what + " cell size", levels[h].cell_size, expected[h].cell_size, 6e-5);
    require(levels[h].particle_count == expected[h].particle_count,
            what + " holds " + std::to_string(levels[h].particle_count));
  }
}

void levels_of_uniform_volume(void **) {
  assert_true(holds(0, [](uint64_t) {
    const std::vector<double> radii = sample(uniform_volume, 50, kCount);
    require_levels(levels_of(filled_box(radii, box_edge(radii), 7)), {{113043, 6.4540},
                                                                      {9676, 14.6440},
                                                                      {1623, 26.5516},
                                                                      {421, 41.6376},
                                                                      {146, 59.2427},
                                                                      {62, 78.8171},
                                                                      {30, 99.5039}});
  }));
}

void levels_of_uniform_size(void **) {
  assert_true(holds(0, [](uint64_t) {
    const std::vector<double> radii = sample(uniform_size, 50, kCount);
    require_levels(levels_of(filled_box(radii, box_edge(radii), 2)), {{90248, 72.7535}, {34753, 99.9996}});
  }));
}

// Equal spheres: one level, m = 6 nu / pi.
void equal_sizes_have_one_level(void **) {
  assert_true(holds(0, [](uint64_t) {
    const std::vector<double> radii(kCount, 1.0);
    const Grid grid = filled_box(radii, box_edge(radii), 0);
    const std::vector<hg_level_cost> costs = costs_of(grid);
    require(!costs.empty() && costs[0].reachable == 1, "one level is not reachable");
    require_near("m", costs[0].occupancy, 6 * 0.62 / kPi, 1e-9);
    for (size_t k = 1; k < costs.size(); k++) require(costs[k].reachable == 0, "more than one level is reachable");
    require(levels_of(grid).size() == 1, "more than one level");
  }));
}

// Two sizes: at most two levels; N_h s_h^3 / V by hand.
void two_sizes_have_two_levels(void **) {
  assert_true(holds(0, [](uint64_t) {
    const std::vector<double> radii = two_sizes(10, kCount);
    require(std::count(radii.begin(), radii.end(), 10.0) == 125, "wrong number of large spheres");
    const double edge = box_edge(radii);
    require_near("box edge", edge, 119.071316, 6e-7);
    const Grid grid = filled_box(radii, edge, 0);
    const std::vector<hg_level_cost> costs = costs_of(grid);
    const double volume = edge * edge * edge;
    require(costs.size() >= 2 && costs[1].reachable == 1, "two levels are not reachable");
    require_near("m(1)", costs[0].occupancy, kCount * 8000 / volume, 1e-6 * 592);
    require_near("m(2)", costs[1].occupancy, 125 * 8000 / volume, 1e-6);
    require_near("cost of 2", costs[1].cost, 1.785, 5e-4);
    for (size_t k = 2; k < costs.size(); k++) require(costs[k].reachable == 0, "more than two levels");
    require_levels(levels_of(grid), {{124876, 2}, {125, 20}});
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(occupancies_and_costs), cmocka_unit_test(levels_of_uniform_volume),
                              cmocka_unit_test(levels_of_uniform_size), cmocka_unit_test(equal_sizes_have_one_level),
                              cmocka_unit_test(two_sizes_have_two_levels)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
