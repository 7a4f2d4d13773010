// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// HG_EXACT with any mix of periodic axes, particles on the faces and many periods outside of the box.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <cmath>

namespace {

using namespace hgtest;

void check_random(uint64_t seed, int dimension, int axes) {
  Rng rng(seed + 10000 * static_cast<uint64_t>(dimension) + 1000 * static_cast<uint64_t>(axes));
  const Sizes sizes = static_cast<Sizes>(rng.below(kSizesCount));
  const size_t count = rng.chance(0.1) ? rng.below(4) : rng.below(301);
  Scene scene = periodic_scene(rng, dimension, axes, count, sizes);
  draw_levels(rng, scene);
  require_exact(scene.name, scene.def, scene.particles);
}

template <int dimension, int axes>
void any_sizes(void **) {
  assert_true(sweep(60, [](uint64_t seed) { check_random(seed, dimension, axes); }));
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
  require_exact("shortest box", def, particles);
}

void shortest_box(void **) {
  assert_true(sweep(60, [](uint64_t seed) { check_shortest(seed, 1); }));
  assert_true(sweep(60, [](uint64_t seed) { check_shortest(seed, 0x1p-40); }));
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
  require_exact("across a face", def, particles);
}

void near_ties_across_a_face(void **) { assert_true(sweep(300, check_face)); }

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
