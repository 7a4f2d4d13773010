// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Boxes among particles of all kinds of scenes against rational numbers: from points to more than all space, touching,
// across periodic faces and far outside them, while particles move within a skin.
#include "oracle/shapes.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace hgtest;

using IdRows = std::vector<std::vector<int32_t>>;

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

// Every axis by itself: an end where a particle touches it, or both around a centre, or anywhere.
void draw_range(Rng &rng, const Scene &scene, int axis, double x, double reach, double *low, double *high) {
  const hg_grid_def &def = scene.def;
  const double size = reach * std::pow(10, rng.uniform(-2, 2));
  const uint64_t kind = rng.below(6);
  *low = kind == 0 ? x + reach : (kind == 1 ? x - reach - size : (kind == 2 ? x : x + size * rng.uniform(-1, 1)));
  *high = kind == 0 ? *low + size : (kind == 1 ? x - reach : (kind == 2 ? x : *low + size * rng.uniform()));
  if (*high < *low) std::swap(*low, *high);
  if (def.periodic[axis] != 0 && rng.chance(0.3)) {
    const double moved = (def.box_max[axis] - def.box_min[axis]) * rng.integer(-1000, 1000);
    *low += moved;
    *high += moved;
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (rng.chance(0.07)) *low = -kInfinity;
  if (rng.chance(0.07)) *high = kInfinity;
  if (rng.chance(0.01)) *low = *high = rng.chance(0.5) ? kInfinity : -kInfinity;
}

void check_boxes(Rng &rng, const Scene &scene, const Grid &grid) {
  const size_t count = 1 + rng.below(20), dimension = static_cast<size_t>(scene.particles.dimension);
  std::vector<double> low(count * dimension), high(count * dimension);
  IdRows expected(count);
  for (size_t k = 0; k < count; k++) {
    const size_t i = rng.below(scene.particles.count());
    const double reach = scene.particles.radii[i] + scene.def.margin;
    for (size_t axis = 0; axis < dimension; axis++) {
      const double x = scene.particles.center(i)[axis];
      // Touching on one axis is to be decided while the others do not count.
      const bool around = rng.chance(0.4);
      double *ends[2] = {&low[k * dimension + axis], &high[k * dimension + axis]};
      draw_range(rng, scene, static_cast<int>(axis), x, reach, ends[0], ends[1]);
      if (around && std::isfinite(*ends[0]) && std::isfinite(*ends[1])) {
        *ends[0] = std::min(*ends[0], x);
        *ends[1] = std::max(*ends[1], x);
      }
    }
    for (size_t n = 0; n < scene.particles.count(); n++) {
      const oracle::Sphere particle{scene.particles.center(n), scene.particles.radii[n]};
      if (oracle::box_meets(scene.def, &low[k * dimension], &high[k * dimension], particle)) {
        expected[k].push_back(static_cast<int32_t>(n) + scene.def.index_base);
      }
    }
  }
  require_rows(scene.name + ", boxes", grid.query_boxes(count, low.data(), high.data()), expected);
}

// Some steps of motion that a skin may bear or not.
template <class Check>
void check_moving(uint64_t seed, Check &&check) {
  Rng rng(seed);
  Scene scene = any_straight_scene(rng);
  Grid grid = make_grid(scene.def, scene.particles);
  for (int step = 0; step < 3; step++) {
    grid.query_pairs();
    check(rng, scene, grid);
    const double far = (scene.def.skin > 0 ? scene.def.skin : largest_reach(scene.def, scene.particles)) * 0.3;
    for (double &x : scene.particles.centers) x += far * rng.uniform(-1, 1);
    for (double &r : scene.particles.radii) r *= rng.uniform(0.9, 1);
    grid.move(scene.particles.count(), scene.particles.centers.data(), scene.particles.radii.data());
  }
}

void boxes(void **) {
  assert_true(sweep(600, [](uint64_t seed) { check_moving(seed, check_boxes); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(boxes)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
