// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// HG_DOUBLE equals the plain expression bit for bit; HG_FLOAT misses nothing and adds only pairs that nearly touch.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <cmath>

namespace {

using namespace hgtest;

void check_double(uint64_t seed) {
  Rng rng(seed);
  Scene scene = any_scene(rng, rng.below(200));
  scene.def.accuracy = HG_DOUBLE;
  const Grid grid = make_grid(scene.def, scene.particles);
  require_same(scene.name.c_str(), sorted_pairs_of(grid), all_pairs(scene.def, scene.particles, double_interact));
}

void double_is_the_plain_expression(void **) { assert_true(sweep(1200, check_double)); }

void require_float(Scene &scene) {
  scene.def.accuracy = HG_FLOAT;
  require_superset(scene.name, scene.def, scene.particles, pairs_of(make_grid(scene.def, scene.particles)),
                   all_pairs(scene.def, scene.particles, exact_interact));
}

void check_float(uint64_t seed) {
  Rng rng(seed);
  Scene scene = any_scene(rng, rng.below(200));
  require_float(scene);
}

// Periodic boxes of just twice the reach, tilted or not, where a particle may touch another through both faces, and
// itself.
void check_float_in_shortest_box(uint64_t seed) {
  Rng rng(seed);
  Scene scene;
  scene.name = "shortest box";
  const double scale = std::ldexp(1, rng.integer(-40, 40));
  for (int k = 0; k < 3; k++) {
    scene.def.periodic[k] = 1;
    scene.def.box_max[k] = (rng.chance(0.3) ? 1e9 : 4) * scale;
    scene.def.tilt[k] = seed % 2 == 0 ? 0.5 * rng.integer(-30, 30) * scale : 0;
  }
  for (int i = 0; i < 30; i++) {
    double x[3];
    for (double &coordinate : x) coordinate = rng.integer(-8, 8) * 0.5 * scale;
    scene.particles.add(x, rng.chance(0.5) ? scale : 0.25 * scale);
  }
  require_float(scene);
}

void float_misses_nothing(void **) {
  assert_true(sweep(1200, check_float));
  assert_true(sweep(60, check_float_in_shortest_box));
}

// Points whose reach is zero never overlap, however the distance is rounded.
void points_never_overlap(void **) {
  assert_true(holds(0, [](uint64_t) {
    for (int accuracy = HG_EXACT; accuracy <= HG_FLOAT; accuracy++) {
      hg_grid_def def = hg_default_grid_def();
      def.accuracy = accuracy;
      Particles particles;
      for (int i = 0; i < 20; i++) {
        const double x[3] = {0x1p-1074 * (i % 3), 0, 0};
        particles.add(x, 0);
      }
      require_same("points", pairs_of(make_grid(def, particles)), {});
    }
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(double_is_the_plain_expression), cmocka_unit_test(float_misses_nothing),
                              cmocka_unit_test(points_never_overlap)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
