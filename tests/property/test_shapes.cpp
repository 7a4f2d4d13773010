// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Boxes and triangles among particles of all kinds of scenes against rational numbers: from points to more than all
// space, touching, across periodic faces and far outside them, while particles move within a skin.
#include "tests/property/shapes.hpp"
#include "tests/support/scenes.hpp"

#include <algorithm>
#include <numeric>

namespace {

using namespace hgtest;

// Any that is not tilted, with a skin or without.
Scene any_straight_scene(Rng &rng) {
  Scene scene = any_scene(rng, 1 + rng.below(200));
  std::fill(scene.def.tilt, scene.def.tilt + 3, 0.0);
  if (can_meet_twice(scene.def, scene.particles)) scene.def.images = HG_ALL_IMAGES;
  scene.def.touching = rng.integer(0, 1);
  scene.def.thread_count = rng.integer(1, 3);
  scene.def.accuracy = rng.integer(HG_EXACT, HG_FLOAT);
  if (rng.chance(0.4)) scene.def.skin = largest_reach(scene.def, scene.particles) * rng.uniform(0, 1);
  return scene;
}

// Some steps of motion that a skin may bear or not.
template <class Check>
void check_moving(uint64_t seed, Check &&check) {
  Rng rng(seed);
  Scene scene = any_straight_scene(rng);
  Grid grid = make_grid(scene.def, scene.particles);
  std::vector<int32_t> ids(scene.particles.count());
  std::iota(ids.begin(), ids.end(), scene.def.index_base);
  for (int step = 0; step < 3; step++) {
    grid.query_pairs();
    check(rng, Population{scene.name, scene.def, scene.particles, ids, grid});
    const double far = (scene.def.skin > 0 ? scene.def.skin : largest_reach(scene.def, scene.particles)) * 0.3;
    for (double &x : scene.particles.centers) x += far * rng.uniform(-1, 1);
    for (double &r : scene.particles.radii) r *= rng.uniform(0.9, 1);
    grid.move(scene.particles.count(), scene.particles.centers.data(), scene.particles.radii.data());
  }
}

void triangles(void **) {
  assert_true(sweep(400, [](uint64_t seed) { check_moving(seed, check_triangles); }));
}

void boxes(void **) {
  assert_true(sweep(600, [](uint64_t seed) { check_moving(seed, check_boxes); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(boxes), cmocka_unit_test(triangles)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
