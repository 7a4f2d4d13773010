// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// HG_EXACT with any mix of periodic axes, particles on the faces and many periods outside of the box.
#include "tests/support/compare.hpp"
#include "tests/support/frame.h"
#include "tests/support/scenes.hpp"

#include <cmath>

namespace {

using namespace hgtest;

void check_random(uint64_t seed, int dimension, int axes) {
  Rng rng(seed);
  const Sizes sizes = static_cast<Sizes>(rng.below(kSizesCount));
  const size_t count = rng.chance(0.1) ? rng.below(4) : rng.below(301);
  Scene scene = periodic_scene(rng, dimension, axes, count, sizes);
  draw_levels(rng, scene);
  const Grid grid = make_grid(scene.def, scene.particles);
  require_same(scene.name.c_str(), sorted_pairs_of(grid), all_pairs(scene.def, scene.particles, exact_interact));
}

template <int dimension, int axes>
void any_sizes(void **) {
  bool all = true;
  for (uint64_t round = 0; round < 60; round++) {
    all &= holds(10000 * dimension + 1000 * axes + round, [](uint64_t seed) { check_random(seed, dimension, axes); });
  }
  assert_true(all);
}

// The shortest box that is allowed: L is twice the reach exactly, so that a particle on the far side of another is
// equally near through both faces, and touches it both ways without overlapping.
void check_shortest(uint64_t seed, double length) {
  Rng rng(seed);
  hg_grid_def def = hg_default_grid_def();
  def.dimension = rng.integer(2, 3);
  const double radius = length / 4;
  Particles particles;
  particles.dimension = def.dimension;
  for (int k = 0; k < def.dimension; k++) {
    def.periodic[k] = 1;
    def.box_min[k] = rng.integer(-8, 8) * length;
    def.box_max[k] = def.box_min[k] + length;
  }
  for (int i = 0; i < 60; i++) {
    double x[3];
    for (double &coordinate : x) coordinate = rng.integer(-64, 64) * (length / 16);
    particles.add(x, rng.chance(0.5) ? radius : rng.uniform(0, radius));
  }
  const Grid grid = make_grid(def, particles);
  require_same("shortest box", sorted_pairs_of(grid), all_pairs(def, particles, exact_interact));
}

void shortest_box(void **) {
  bool all = true;
  for (uint64_t seed = 0; seed < 60; seed++) {
    all &= holds(seed, [](uint64_t s) { check_shortest(s, 1); });
    all &= holds(seed, [](uint64_t s) { check_shortest(s, 0x1p-40); });
  }
  assert_true(all);
}

// Pairs that touch across a face up to a few units in the last place, with a box whose length is not a double.
void check_face(uint64_t seed) {
  Rng rng(seed);
  hg_grid_def def = hg_default_grid_def();
  def.thread_count = 1;
  def.periodic[0] = 1;
  def.box_min[0] = rng.uniform(-1, 0) * 0.1;
  def.box_max[0] = rng.uniform(2, 3);
  Particles particles;
  for (int i = 0; i < 40; i++) {
    const double r = rng.uniform(0.01, 0.1);
    const double s = rng.uniform(0.01, 0.1);
    const double y = 10.0 * i;
    double low[3] = {def.box_min[0] + rng.uniform(0, 0.05), y, 0};
    double high[3] = {low[0] - (r + s) + (def.box_max[0] - def.box_min[0]), y, 0};
    high[0] += rng.integer(-3, 3) * 0x1p-52 + rng.integer(-5, 5) * (def.box_max[0] - def.box_min[0]);
    particles.add(low, r);
    particles.add(high, s);
  }
  const Grid grid = make_grid(def, particles);
  require_same("across a face", sorted_pairs_of(grid), all_pairs(def, particles, exact_interact));
}

void near_ties_across_a_face(void **) {
  bool all = true;
  for (uint64_t seed = 0; seed < 300; seed++) all &= holds(seed, check_face);
  assert_true(all);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test((any_sizes<2, 1>)), cmocka_unit_test((any_sizes<2, 2>)),
                              cmocka_unit_test((any_sizes<2, 3>)), cmocka_unit_test((any_sizes<3, 1>)),
                              cmocka_unit_test((any_sizes<3, 2>)), cmocka_unit_test((any_sizes<3, 3>)),
                              cmocka_unit_test((any_sizes<3, 4>)), cmocka_unit_test((any_sizes<3, 5>)),
                              cmocka_unit_test((any_sizes<3, 6>)), cmocka_unit_test((any_sizes<3, 7>)),
                              cmocka_unit_test(shortest_box),      cmocka_unit_test(near_ties_across_a_face)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
