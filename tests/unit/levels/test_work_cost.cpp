// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The work that levels are expected to cost: tests against the library's own count of candidates, rows against throws
// of balls onto rows, the sum against its terms, and the ends of doubles.
#include "src/grid.hpp"
#include "src/levels/work_cost.hpp"
#include "src/space/level_cells.hpp"
#include "tests/unit/checks.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace hgtest;

struct Input {
  hg_grid_def def;
  std::vector<double> centers, radii;
};

// Even in a periodic box of edge 1, so that no surface spoils the counts; p(r) ~ r^-3, at 0.3 of the volume.
Input even_input(uint64_t seed, int dimension, size_t count, double ratio) {
  Rng rng(seed);
  Input in;
  hg::fill_defaults(&in.def, sizeof in.def);
  in.def.dimension = dimension;
  in.def.thread_count = 1;
  double volume = 0;
  for (size_t i = 0; i < count; i++) {
    for (int axis = 0; axis < dimension; axis++) in.centers.push_back(rng.uniform());
    in.radii.push_back(1 / std::sqrt(1 - rng.uniform() * (1 - 1 / (ratio * ratio))));
    volume += std::pow(in.radii.back(), dimension) * (dimension == 3 ? 4.19 : 3.14);
  }
  for (double &r : in.radii) r *= std::pow(0.3 / volume, 1.0 / dimension);
  for (int axis = 0; axis < dimension; axis++) {
    in.def.periodic[axis] = 1;
    in.def.box_max[axis] = 1;
  }
  return in;
}

struct Outcome {
  double cost;
  hg_grid_stats stats;
  std::vector<hg_level> levels;
};

Outcome search(Input in, int levels, double level_price, double row_price) {
  in.def.level_count = levels;
  in.def.level_price = level_price;
  in.def.row_price = row_price;
  hg::Grid grid(hg::check_definition(in.def), hg::system_allocator());
  grid.insert(in.radii.size(), in.centers.data(), in.radii.data());
  const hg_pair *pairs = nullptr;
  const hg_level *found = nullptr;
  const hg_level_cost *costs = nullptr;
  size_t count = 0;
  grid.query_pairs(&pairs, &count);
  grid.query_levels(&found, &count);
  Outcome outcome{0, grid.stats(), {found, found + count}};
  require(static_cast<int>(count) == levels, "%zu levels instead of %d", count, levels);
  grid.query_level_costs(&costs, &count);
  outcome.cost = costs[levels - 1].cost;
  return outcome;
}

void check_tests(uint64_t seed) {
  const int dimension = seed % 2 == 0 ? 3 : 2;
  Input in = even_input(seed, dimension, 20000, 8);
  if (seed % 3 == 1) in.def.margin = 0.3 * in.radii[0];
  if (seed % 3 == 2) in.def.interaction = HG_MAX_RANGE;
  for (int levels = 1; levels <= 4; levels++) {
    const Outcome outcome = search(in, levels, 0, 0);
    const double counted = static_cast<double>(outcome.stats.candidate_count) / 20000;
    require(std::fabs(outcome.cost / counted - 1) < 0.2, "%d levels: %g tests expected, %g made", levels, outcome.cost,
            counted);
  }
}

void tests_are_counted(void **) { assert_true(sweep(12, check_tests)); }

// Rows met by balls thrown onto rows of width 1: a square (interval) at each place of a lattice.
double rows_met(Rng &rng, int dimension, double w) {
  const int far = static_cast<int>(w) + 2;
  double met = 0;
  constexpr int kThrows = 200;
  for (int t = 0; t < kThrows; t++) {
    const double y = rng.uniform(), z = dimension == 3 ? rng.uniform() : 0.5;
    for (int j = -far; j <= far; j++) {
      for (int i = dimension == 3 ? -far : 0; i <= (dimension == 3 ? far : 0); i++) {
        const double gap_y = std::max({0.0, j - y, y - (j + 1)}), gap_z = std::max({0.0, i - z, z - (i + 1)});
        met += gap_y * gap_y + gap_z * gap_z < w * w ? 1 : 0;
      }
    }
  }
  return met / kThrows;
}

void check_rows(uint64_t seed) {
  const int dimension = seed % 2 == 0 ? 3 : 2;
  const Input in = even_input(seed, dimension, 20000, 8);
  const Outcome without = search(in, 3, 0, 0), with = search(in, 3, 0, 1);
  Rng rng(seed);
  double expected = 0;
  for (size_t h = 1; h < 3; h++) {
    for (size_t k = 0; k < h; k++) {
      const hg_level &fine = without.levels[k];
      const double width = 1 / std::floor(1 / (hg::kRowWidth * fine.cell_size));
      for (const double r : in.radii) {
        const bool here = r <= without.levels[h].largest_radius && r > without.levels[h - 1].largest_radius;
        if (!here || !rng.chance(0.1)) continue;
        expected += 10 * rows_met(rng, dimension, (r + fine.largest_radius) / width) / 20000;
      }
    }
  }
  const double rows = with.cost - without.cost;
  require(std::fabs(rows / expected - 1) < 0.1, "%g rows expected, %g met", rows, expected);
}

void rows_are_counted(void **) { assert_true(sweep(6, check_rows)); }

void check_sum(uint64_t) {
  const Input in = even_input(5, 3, 5000, 8);
  for (int levels = 1; levels <= 3; levels++) {
    const double tests = search(in, levels, 0, 0).cost, rows = search(in, levels, 0, 1).cost - tests;
    const double sum = search(in, levels, 3, 7).cost;
    require(std::fabs(sum - (3 * levels + 7 * rows + tests)) <= 1e-12 * sum, "%d levels: cost %.17g", levels, sum);
  }
}

void prices_add_up(void **) { assert_true(holds(0, check_sum)); }

// The same plan whatever the kernels and threads: it is made of doubles alone. Here: of the same input twice, and with
// several threads.
void check_same(uint64_t seed) {
  Input in = even_input(seed, 3, 30000, 30);
  in.def.level_price = 1;
  const Outcome one = search(in, 4, 1, 5);
  in.def.thread_count = 3;
  const Outcome other = search(in, 4, 1, 5);
  require(one.cost == other.cost, "%.17g and %.17g", one.cost, other.cost);
}

void threads_do_not_matter(void **) { assert_true(sweep(2, check_same)); }

// Radii and places of any size: costs are numbers, levels sound.
void check_extremes(uint64_t seed) {
  Rng rng(seed);
  Input in;
  hg::fill_defaults(&in.def, sizeof in.def);
  in.def.dimension = rng.integer(2, 3);
  in.def.interaction = rng.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE;
  static constexpr double kMargins[] = {0, 5e-324, 1, 1e150};
  in.def.margin = kMargins[rng.below(4)];
  const int least = rng.integer(-1074, 500), most = rng.integer(least, 500);
  const size_t count = 1 + rng.below(300);
  for (size_t i = 0; i < count; i++) {
    for (int axis = 0; axis < in.def.dimension; axis++)
      in.centers.push_back(std::ldexp(rng.uniform() - 0.5, least + 9));
    in.radii.push_back(rng.chance(0.1) ? 0 : std::ldexp(rng.uniform(), rng.integer(least, most)));
  }
  hg::Grid grid(hg::check_definition(in.def), hg::system_allocator());
  grid.insert(count, in.centers.data(), in.radii.data());
  const hg_level_cost *costs = nullptr;
  const hg_level *levels = nullptr;
  size_t cost_count = 0, level_count = 0;
  grid.query_level_costs(&costs, &cost_count);
  grid.query_levels(&levels, &level_count);
  int64_t particles = 0;
  for (size_t h = 0; h < level_count; h++) particles += levels[h].particle_count;
  require(particles == static_cast<int64_t>(count), "%lld of %zu particles on levels",
          static_cast<long long>(particles), count);
  for (size_t k = 0; k < cost_count; k++) {
    require(costs[k].cost >= 0 && std::isfinite(costs[k].cost), "cost of %zu levels: %g", k + 1, costs[k].cost);
    require(costs[k].cost <= 18.0 * 4e10, "cost of %zu levels: %g", k + 1, costs[k].cost);
  }
}

void extremes(void **) { assert_true(sweep(300, check_extremes)); }

// 1e6 : 1, one giant in dust: two levels, and the giant's rows are not more than there are.
void check_giant(uint64_t) {
  Input in = even_input(7, 3, 20000, 1.0001);
  in.def.periodic[0] = in.def.periodic[1] = in.def.periodic[2] = 0;
  for (double &r : in.radii) r = 1e-6;
  in.radii[77] = 1;
  in.def.level_price = -1;
  hg::Grid grid(hg::check_definition(in.def), hg::system_allocator());
  grid.insert(in.radii.size(), in.centers.data(), in.radii.data());
  const hg_level_cost *costs = nullptr;
  size_t count = 0;
  grid.query_level_costs(&costs, &count);
  require(count == 2, "%zu numbers of levels of two sizes", count);
  require(costs[0].cost > 9000, "one level: every pair is tested, at least %g", costs[0].cost);
  require(costs[1].cost < 100, "two levels cost %g", costs[1].cost);
}

void giant(void **) { assert_true(holds(0, check_giant)); }

// Fitted prices rise from 2^17 to 2^20 particles, evenly with the logarithm; those of the caller stay.
void check_fitted(uint64_t) {
  const hg::WorkPrices fitted, own{3, 5}, none{0, 0};
  const hg::WorkPrices cached = fitted.fitted(1 << 17), large = fitted.fitted(1 << 20);
  require(cached.level == 4 && cached.row == 18 && large.level == 12 && large.row == 24, "fitted prices");
  for (const size_t few : {size_t{0}, size_t{1}, size_t{1000}}) require(fitted.fitted(few).level == 4, "of few");
  require(fitted.fitted(size_t{1} << 31).row == 24, "of many");
  const hg::WorkPrices one = fitted.fitted(1 << 18), two = fitted.fitted(1 << 19);
  require(two.level - one.level == one.level - cached.level && large.row - two.row == two.row - one.row, "octaves");
  double before = 0;
  for (size_t n = 1 << 16; n < size_t{1} << 21; n += 997) {
    const double level = fitted.fitted(n).level;
    require(level >= before, "%g at %zu particles, %g before", level, n, before);
    before = level;
  }
  require(own.fitted(1 << 20).level == 3 && own.fitted(1 << 20).row == 5 && none.fitted(1 << 20).level == 0, "own");
}

void fitted_prices(void **) { assert_true(holds(0, check_fitted)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(tests_are_counted),
      cmocka_unit_test(rows_are_counted),
      cmocka_unit_test(prices_add_up),
      cmocka_unit_test(fitted_prices),
      cmocka_unit_test(threads_do_not_matter),
      cmocka_unit_test(extremes),
      cmocka_unit_test(giant),
  };
  return cmocka_run_group_tests_name("work_cost", tests, nullptr, nullptr);
}
