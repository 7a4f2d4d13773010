// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hg_query_order is a permutation of the live ids, and near particles stand together in it, whatever the extents.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace {

using namespace hgtest;

std::vector<int32_t> order_of(const Grid &grid) {
  const hgrid::View<int32_t> ids = grid.query_order();
  return {ids.begin(), ids.end()};
}

// In any scene, after removal, and the same for any number of threads.
void a_permutation(void **) {
  assert_true(sweep(200, [](uint64_t seed) {
    Rng rng(seed);
    Scene scene = any_scene(rng, rng.below(200));
    std::vector<int32_t> first;
    for (const int32_t threads : {1, 3}) {
      scene.def.thread_count = threads;
      Grid grid = make_grid(scene.def, scene.particles);
      std::vector<int32_t> left, gone;
      for (size_t row = 0; row < scene.particles.count(); row++) {
        ((row * 2654435761u >> 7) % 4 == 0 ? gone : left).push_back(scene.def.index_base + static_cast<int32_t>(row));
      }
      grid.remove(gone.size(), gone.data());
      std::vector<int32_t> ids = order_of(grid);
      if (threads == 1) first = ids;
      require_same("another number of threads", ids, first);
      std::sort(ids.begin(), ids.end());
      require_same("a permutation", ids, left);
    }
  }));
}

// The median distance of those that follow each other.
double median_step(const Particles &particles, const std::vector<int32_t> &ids, double length) {
  std::vector<double> steps;
  for (size_t k = 1; k < ids.size(); k++) {
    double d2 = 0;
    for (int axis = 0; axis < particles.dimension; axis++) {
      const size_t a = static_cast<size_t>(ids[k - 1]), b = static_cast<size_t>(ids[k]);
      double d = particles.center(b)[axis] - particles.center(a)[axis];
      if (length > 0) d = std::remainder(d, length);
      d2 += d * d;
    }
    steps.push_back(std::sqrt(d2));
  }
  std::nth_element(steps.begin(), steps.begin() + static_cast<ptrdiff_t>(steps.size() / 2), steps.end());
  return steps[steps.size() / 2];
}

void require_near(const char *what, const hg_grid_def &def, const Particles &particles, double expected,
                  double length) {
  const double step = median_step(particles, order_of(make_grid(def, particles)), length);
  require(step < expected, std::string(what) + ": a median step of " + std::to_string(step / expected) + " bounds");
}

// N points in a box of edge 1 are about N^(-1/d) apart; along the curve they are hardly farther.
void near_ones_stand_together(void **) {
  assert_true(sweep(20, [](uint64_t seed) {
    Rng rng(seed);
    hg_grid_def def = hg_default_grid_def();
    def.dimension = rng.integer(2, 3);
    const bool periodic = rng.chance(0.5);
    Particles particles;
    particles.dimension = def.dimension;
    constexpr int kCount = 4096;
    for (int i = 0; i < kCount; i++) {
      double x[3] = {rng.uniform(), rng.uniform(), rng.uniform()};
      for (double &coordinate : x) coordinate += periodic ? rng.integer(-3, 3) : 0;
      particles.add(x, 0.001);
    }
    for (int k = 0; k < def.dimension; k++) {
      def.periodic[k] = periodic ? 1 : 0;
      def.box_max[k] = 1;
    }
    require_near("uniform", def, particles, 1.5 * std::pow(kCount, -1.0 / def.dimension), periodic ? 1 : 0);
  }));
}

// Groups far apart, some much finer than others; then all beside one particle at an enormous distance.
void groups_far_apart(void **) {
  assert_true(sweep(20, [](uint64_t seed) {
    Rng rng(seed);
    Particles particles;
    constexpr int kGroups = 8, kEach = 512;
    for (int i = 0; i < kGroups * kEach; i++) {
      double x[3];
      for (int k = 0; k < 3; k++) x[k] = 1e6 * (i % kGroups >> k & 1) + rng.uniform();
      particles.add(x, 0.01);
    }
    const double expected = 1.5 / 8;  // 512 = 8^3 in each
    const hg_grid_def def = hg_default_grid_def();
    require_near("groups", def, particles, expected, 0);
    const double outlier[3] = {1e30, -1e20, 0};
    particles.add(outlier, 0.01);
    require_near("groups and an outlier", def, particles, expected, 0);
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(a_permutation), cmocka_unit_test(near_ones_stand_together),
                              cmocka_unit_test(groups_far_apart)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
