// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The choice of levels: against Appendix A written literally, against reference values, and at the ends of doubles.
#include "src/levels/level_plan.hpp"
#include "src/levels/occupancy_cost.hpp"
#include "tests/support/size_laws.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/levels/literal_levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace hgtest;
using hg::LevelPlan;
using hg::LevelRequest;

constexpr double kPi = 3.14159265358979323846;
constexpr double kLargest = std::numeric_limits<double>::max();

LevelPlan plan_of(const std::vector<double> &radii, const LevelRequest &request, double overhead) {
  hg::Memory memory(hg::system_allocator());
  hg::SizeClasses classes(memory);
  hg::Interval extremes{0, 0};
  if (!radii.empty())
    extremes = {*std::min_element(radii.begin(), radii.end()), *std::max_element(radii.begin(), radii.end())};
  classes.sort_radii(radii.data(), radii.size(), extremes);
  return hg::plan_levels(classes, request, hg::OccupancyCost(overhead));
}

LevelRequest cube(double edge) {
  LevelRequest request;
  request.volume.edge = edge;
  return request;
}

// Whatever the rule chose: cells and radii ascend, the last level takes all, and no particle is lost.
void require_sound(const LevelPlan &plan, const std::vector<double> &radii) {
  require(plan.level_count >= 1 && plan.level_count <= HG_MAX_LEVELS, "%d levels", plan.level_count);
  int64_t particles = 0;
  double below = -1;
  for (int h = 0; h < plan.level_count; h++) {
    const hg::PlannedLevel &level = plan.levels[h];
    require(h == 0 || level.cell_size > plan.levels[h - 1].cell_size, "cell size of level %d does not ascend", h);
    const int64_t held =
        std::count_if(radii.begin(), radii.end(), [&](double r) { return r > below && r <= level.radius_limit; });
    require(held == level.particles, "level %d plans for %lld particles but takes %lld", h,
            static_cast<long long>(level.particles), static_cast<long long>(held));
    require(held > 0, "level %d is empty", h);
    particles += held;
    below = level.radius_limit;
  }
  require(particles == static_cast<int64_t>(radii.size()), "%lld particles have a level",
          static_cast<long long>(particles));
}

std::vector<double> any_radii(Rng &rng) {
  std::vector<double> radii(1 + rng.below(30));
  const int distinct = rng.integer(1, 12);
  const int kind = rng.integer(0, 2);
  for (double &r : radii) {
    if (kind == 0) r = rng.uniform(0.5, 1);
    if (kind == 1) r = std::ldexp(1.0, -rng.integer(0, distinct));
    if (kind == 2) r = std::pow(10, rng.uniform(-3, 0));
  }
  return radii;
}

void check_literal(uint64_t seed) {
  Rng rng(seed);
  std::vector<double> radii = any_radii(rng);
  LevelRequest request = cube(std::pow(10, rng.uniform(-1, 2)));
  request.volume.dimension = rng.integer(2, 3);
  const double overhead = rng.uniform(0, 3);
  const LevelPlan plan = plan_of(radii, request, overhead);
  require_sound(plan, radii);

  std::sort(radii.begin(), radii.end());
  const std::vector<LiteralCost> expected = literal_costs(radii, {request.volume.dimension, request.volume.edge}, 16);
  require(plan.cost_count >= 16, "only %d numbers of levels were looked at", plan.cost_count);
  double best = HUGE_VAL;
  size_t best_count = 0;
  for (size_t L = 1; L <= expected.size(); L++) {
    const LiteralCost &e = expected[L - 1];
    const hg_level_cost &cost = plan.costs[L - 1];
    require(cost.level_count == static_cast<int>(L), "cost %zu is of %d levels", L, cost.level_count);
    require(cost.reachable == (e.reachable ? 1 : 0), "L = %zu: reachable must be %d", L, e.reachable);
    if (!e.reachable) {
      require(cost.occupancy == 0 && cost.cost == 0, "L = %zu: unreachable, but m = %g", L, cost.occupancy);
      continue;
    }
    require(std::fabs(cost.occupancy - e.occupancy) <= 1e-14 * e.occupancy, "L = %zu: m = %.17g instead of %.17g", L,
            cost.occupancy, e.occupancy);
    const double f = static_cast<double>(L) * (e.occupancy + overhead);
    require(std::fabs(cost.cost - f) <= 1e-14 * f, "L = %zu: cost %.17g instead of %.17g", L, cost.cost, f);
    if (cost.cost < best) {
      best = cost.cost;
      best_count = L;
    }
  }
  if (static_cast<size_t>(plan.level_count) > expected.size()) return;
  require(static_cast<size_t>(plan.level_count) == best_count, "%d levels, %zu are cheapest", plan.level_count,
          best_count);
  for (size_t h = 0; h < best_count; h++) {
    const LiteralLevel &e = expected[best_count - 1].levels[h];
    require(plan.levels[h].particles == static_cast<int64_t>(e.count) && plan.levels[h].cell_size == e.cell_size,
            "level %zu: %lld @ %g instead of %zu @ %g", h, static_cast<long long>(plan.levels[h].particles),
            plan.levels[h].cell_size, e.count, e.cell_size);
  }
}

void literal_appendix_a(void **) { assert_true(sweep(150, check_literal)); }

double edge_filled(const std::vector<double> &radii, double fraction) {
  double cubes = 0;
  for (double r : radii) cubes += r * r * r;
  return std::cbrt(4 * kPi / 3 * cubes / fraction);
}

void check_uniform_volume_50(uint64_t) {
  const std::vector<double> radii = sample(uniform_volume, 50, 125001);
  const LevelRequest request = cube(edge_filled(radii, 0.62));
  require(std::fabs(request.volume.edge - 435.847842) < 1e-6, "S = %.9g", request.volume.edge);
  const LevelPlan plan = plan_of(radii, request, 0.3);
  require_sound(plan, radii);
  static constexpr double kOccupancy[10] = {1487.405412, 13.286065, 2.745570, 1.205023, 0.713949,
                                            0.488022,    0.367057,  0.291491, 0.239180, 0.203122};
  for (int L = 1; L <= 10; L++) {
    require(std::fabs(plan.costs[L - 1].occupancy - kOccupancy[L - 1]) < 1e-6, "m(%d) = %.9g", L,
            plan.costs[L - 1].occupancy);
  }
  require(plan.level_count == 7, "%d levels", plan.level_count);
  static constexpr int64_t kParticles[7] = {113043, 9676, 1623, 421, 146, 62, 30};
  static constexpr double kCells[7] = {6.4540, 14.6440, 26.5516, 41.6376, 59.2427, 78.8171, 99.5039};
  for (int h = 0; h < 7; h++) {
    require(plan.levels[h].particles == kParticles[h] && std::fabs(plan.levels[h].cell_size - kCells[h]) < 5.1e-5,
            "level %d: %lld @ %.8g", h, static_cast<long long>(plan.levels[h].particles), plan.levels[h].cell_size);
  }
}

// The best number of levels falls as visiting cells gets dearer.
void check_overheads(uint64_t) {
  const std::vector<double> radii = sample(uniform_volume, 50, 125001);
  const double edge = edge_filled(radii, 0.62);
  static constexpr struct {
    double overhead;
    int levels;
  } kExpected[] = {{0.2, 8}, {0.25, 7}, {0.35, 7}, {0.4, 6}, {0.45, 6}};
  for (const auto &e : kExpected) {
    const int levels = plan_of(radii, cube(edge), e.overhead).level_count;
    require(levels == e.levels, "K = %g: %d levels instead of %d", e.overhead, levels, e.levels);
  }
}

void check_two_sizes(uint64_t) {
  std::vector<double> radii(124876, 1.0);
  radii.resize(125001, 10.0);
  const LevelPlan plan = plan_of(radii, cube(119.071316), 0.3);
  require(plan.level_count == 2, "%d levels", plan.level_count);
  require(plan.levels[0].particles == 124876 && plan.levels[0].cell_size == 2, "the small ones");
  require(plan.levels[1].particles == 125 && plan.levels[1].cell_size == 20, "the large ones");
  require(std::fabs(plan.costs[0].occupancy - 592.355) < 1e-3, "m(1) = %.9g", plan.costs[0].occupancy);
  require(std::fabs(plan.costs[1].occupancy - 0.5924) < 1e-4, "m(2) = %.9g", plan.costs[1].occupancy);
  require(std::fabs(plan.costs[1].cost - 1.785) < 1e-3, "f(2) = %.9g", plan.costs[1].cost);
  for (int L = 3; L <= plan.cost_count; L++) require(plan.costs[L - 1].reachable == 0, "L = %d is reachable", L);

  LevelRequest five = cube(119.071316);
  five.level_count = 5;
  require(plan_of(radii, five, 0.3).level_count == 2, "five levels of two sizes");
  five.level_count = 1;
  require(plan_of(radii, five, 0.3).levels[0].cell_size == 20, "one level of two sizes");
}

void check_one_size(uint64_t) {
  const std::vector<double> radii(1000, 1.0);
  const LevelPlan plan = plan_of(radii, cube(edge_filled(radii, 0.62)), 0.3);
  require(plan.level_count == 1, "%d levels", plan.level_count);
  require(std::fabs(plan.costs[0].occupancy - 6 * 0.62 / kPi) < 1e-12, "m = %.17g", plan.costs[0].occupancy);
}

void uniform_volume_50(void **) { assert_true(holds(0, check_uniform_volume_50)); }
void overheads(void **) { assert_true(holds(0, check_overheads)); }
void two_sizes(void **) { assert_true(holds(0, check_two_sizes)); }
void one_size(void **) { assert_true(holds(0, check_one_size)); }

// Cells hold what two particles can reach: margin and ranges included.
void check_interactions(uint64_t) {
  const std::vector<double> radii = {1, 1, 4};
  LevelRequest request = cube(20);
  request.level_count = 2;
  request.interaction = {HG_CONTACT, 0.5};
  LevelPlan plan = plan_of(radii, request, 0.3);
  require(plan.levels[0].cell_size == 2.5 && plan.levels[1].cell_size == 8.5, "contact with a margin");
  request.interaction = {HG_MAX_RANGE, 0.5};
  plan = plan_of(radii, request, 0.3);
  require(plan.levels[0].cell_size == 1.5 && plan.levels[1].cell_size == 4.5, "ranges with a margin");
}

// m(L) to a relative precision: never more than that above the exact one.
void check_precision(uint64_t seed) {
  Rng rng(seed);
  std::vector<double> radii(2000);
  for (double &r : radii) r = 1 / std::sqrt(1 - rng.uniform() * (1 - 1e-4));
  LevelRequest request = cube(edge_filled(radii, 0.6));
  const LevelPlan exact = plan_of(radii, request, 0.3);
  request.precision = 1e-3;
  const LevelPlan rounded = plan_of(radii, request, 0.3);
  require_sound(rounded, radii);
  for (int L = 1; L <= 16; L++) {
    if (exact.costs[L - 1].reachable == 0 || rounded.costs[L - 1].reachable == 0) continue;
    const double ratio = rounded.costs[L - 1].occupancy / exact.costs[L - 1].occupancy;
    require(ratio <= 1.001 + 1e-12, "L = %d: m is %g times the exact one", L, ratio);
  }
}

void interactions(void **) { assert_true(holds(0, check_interactions)); }
void precision(void **) { assert_true(sweep(10, check_precision)); }

// (2r/S)^d under- and overflows; still no particle may be lost.
void check_extremes(uint64_t seed) {
  Rng rng(seed);
  static constexpr double kEdges[] = {0, 5e-324, 1e-300, 1e-120, 1, 1e120, 1e300, kLargest, HUGE_VAL};
  static constexpr double kOverheads[] = {0, 0.3, 1e308};
  for (double edge : kEdges) {
    for (double overhead : kOverheads) {
      std::vector<double> radii(1 + rng.below(40));
      for (double &r : radii) r = rng.chance(0.2) ? 0 : std::ldexp(1 + rng.uniform(), rng.integer(-1074, 1022));
      LevelRequest request = cube(edge);
      request.volume.dimension = rng.integer(2, 3);
      const LevelPlan plan = plan_of(radii, request, overhead);
      require_sound(plan, radii);
      for (int k = 0; k < plan.cost_count; k++) {
        require(!std::isnan(plan.costs[k].cost) && plan.costs[k].occupancy >= 0, "S = %g: cost %g", edge,
                plan.costs[k].cost);
      }
    }
  }
}

void extremes(void **) { assert_true(sweep(15, check_extremes)); }

void check_many_sizes(uint64_t) {
  std::vector<double> radii(300);
  for (size_t k = 0; k < radii.size(); k++) radii[k] = std::ldexp(1.0, static_cast<int>(k));
  LevelRequest request = cube(0x1p301);
  const LevelPlan free = plan_of(radii, request, 0);
  require_sound(free, radii);
  require(free.cost_count == HG_MAX_LEVELS, "%d numbers of levels were looked at", free.cost_count);
  request.level_count = 10;
  const LevelPlan ten = plan_of(radii, request, 0);
  require_sound(ten, radii);
  require(ten.level_count <= 10 && ten.cost_count == 10, "%d levels", ten.level_count);
}

void many_sizes(void **) { assert_true(holds(0, check_many_sizes)); }

void check_occupancy(uint64_t) {
  hg::FilledVolume volume{3, 10};
  require(hg::occupancy(1000, 2, volume) == 1000 * (0.2 * 0.2 * 0.2), "3D");
  volume.dimension = 2;
  require(hg::occupancy(1000, 2, volume) == 1000 * (0.2 * 0.2), "2D");
  volume.edge = 0;
  require(hg::occupancy(7, 2, volume) == 7, "no volume: all in one cell");
  require(hg::occupancy(7, 0, volume) == 0, "no volume, no cells");
  volume.edge = 1e-200;
  require(hg::occupancy(7, 1, volume) == kLargest, "overflow");
  require(hg::occupancy(0, 1, volume) == 0, "no particles: %g", hg::occupancy(0, 1, volume));
}

// V = S^d, even where the product of the widths overflows.
void check_filled_volume(uint64_t) {
  hg::Bounds bounds;
  const double widths[3] = {8, 1, 27};
  std::copy(widths, widths + 3, bounds.width);
  const hg::FilledVolume box = hg::FilledVolume::of(bounds, 3), plane = hg::FilledVolume::of(bounds, 2);
  require(box.dimension == 3 && std::fabs(box.edge / 6 - 1) < 1e-14, "S = %.17g", box.edge);
  require(plane.dimension == 2 && std::fabs(plane.edge / std::sqrt(8) - 1) < 1e-14, "S = %.17g", plane.edge);
  for (double &width : bounds.width) width = 1e300;
  require(std::fabs(hg::FilledVolume::of(bounds, 3).edge / 1e300 - 1) < 1e-12, "S of a wide box");
}

void occupancies(void **) { assert_true(holds(0, check_occupancy)); }
void filled_volumes(void **) { assert_true(holds(0, check_filled_volume)); }

// The limit of a level is the largest radius whose diameter still fits, to the last bit.
void check_user_levels(uint64_t seed) {
  Rng rng(seed);
  hg::Interaction interaction;
  interaction.kind = rng.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE;
  static constexpr double kMargins[] = {0, 5e-324, 1e-3, 1, 1e300};
  interaction.margin = kMargins[rng.below(5)];
  std::vector<double> sizes = {5e-324, 1e-310, kLargest, interaction.margin > 0 ? interaction.margin : 1};
  for (int k = 0; k < 20; k++) sizes.push_back(std::ldexp(1 + rng.uniform(), rng.integer(-1074, 1022)));
  std::sort(sizes.begin(), sizes.end());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  const LevelPlan plan = hg::user_levels(sizes.data(), static_cast<int>(sizes.size()), interaction);
  require(plan.level_count == static_cast<int>(sizes.size()), "%d levels", plan.level_count);
  for (int h = 0; h < plan.level_count; h++) {
    const double s = sizes[static_cast<size_t>(h)], limit = plan.levels[h].radius_limit;
    require(plan.levels[h].cell_size == s, "cell size %g instead of %g", plan.levels[h].cell_size, s);
    if (interaction.margin > s) {
      require(limit < 0, "s = %g is below the margin %g but takes radii up to %g", s, interaction.margin, limit);
      continue;
    }
    const double next = std::nextafter(limit, HUGE_VAL);
    require(limit >= 0 && interaction.diameter(limit) <= s, "s = %g: diameter(%a) = %a does not fit", s, limit,
            interaction.diameter(limit));
    require(interaction.diameter(next) > s, "s = %g: diameter(%a) would fit", s, next);
  }
}

void user_limits(void **) { assert_true(sweep(300, check_user_levels)); }

void no_particles(void **) {
  int levels = -1;
  const bool ok = holds(0, [&](uint64_t) { levels = plan_of({}, cube(1), 0.3).level_count; });
  assert_true(ok);
  assert_int_equal(levels, 0);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(literal_appendix_a), cmocka_unit_test(uniform_volume_50), cmocka_unit_test(overheads),
      cmocka_unit_test(two_sizes),          cmocka_unit_test(one_size),          cmocka_unit_test(interactions),
      cmocka_unit_test(precision),          cmocka_unit_test(extremes),          cmocka_unit_test(many_sizes),
      cmocka_unit_test(occupancies),        cmocka_unit_test(filled_volumes),    cmocka_unit_test(user_limits),
      cmocka_unit_test(no_particles),
  };
  return cmocka_run_group_tests_name("level_plan", tests, nullptr, nullptr);
}
