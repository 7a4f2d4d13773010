// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Boxes and triangles among particles of all kinds of scenes against rational numbers: from points to more than all
// space, touching, across periodic faces and far outside them, while particles move within a skin.
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

// Corners around a particle at the distance where they touch, or anywhere; some triangles are needles, segments or
// points, some lie in the plane that touches the particle.
void draw_triangle(Rng &rng, const Scene &scene, double *corners) {
  const size_t i = rng.below(scene.particles.count());
  const double *x = scene.particles.center(i);
  const double reach = scene.particles.radii[i] + scene.def.margin;
  const double size =
      (reach > 0 ? reach : largest_reach(scene.def, scene.particles)) * std::pow(10, rng.uniform(-2, 1.5));
  const uint64_t kind = rng.below(6);
  for (int k = 0; k < 9; k++) corners[k] = x[k % 3] + size * rng.uniform(-1, 1);
  const uint64_t axis = rng.below(3), corner = rng.below(3);
  const double side = rng.chance(0.5) ? reach : -reach;
  for (uint64_t k = 0; k < 3 && kind == 0; k++) corners[3 * k + axis] = x[axis] + side;
  if (kind == 1) {
    std::copy_n(x, 3, corners + 3 * corner);
    corners[3 * corner + axis] += side;
  }
  if (kind == 2) std::copy_n(corners, 3, corners + 3);
  if (kind == 3) std::copy_n(corners, 3, std::copy_n(corners, 3, corners + 3));
  if (kind == 4) {
    const double t = rng.uniform(-0.5, 1.5), off = size * std::pow(2, rng.uniform(-60, -1));
    for (int k = 0; k < 3; k++)
      corners[6 + k] = corners[k] + t * (corners[3 + k] - corners[k]) + off * rng.uniform(-1, 1);
  }
  for (int k = 0; k < 3; k++) {
    if (scene.def.periodic[k] == 0 || rng.chance(0.7)) continue;
    const double moved = (scene.def.box_max[k] - scene.def.box_min[k]) * rng.integer(-1000, 1000);
    for (int c = 0; c < 3; c++) corners[3 * c + k] += moved;
  }
}

// So that the oracle need not look at very many.
bool has_few_images(const Scene &scene, const double *corners, double reach) {
  double images = 1;
  for (int axis = 0; axis < 3; axis++) {
    if (scene.def.periodic[axis] == 0) continue;
    const auto [low, high] = std::minmax({corners[axis], corners[3 + axis], corners[6 + axis]});
    images *= 2 + (high - low + 2 * reach) / (scene.def.box_max[axis] - scene.def.box_min[axis]);
  }
  return images < 200;
}

void check_triangle_row(const Scene &scene, const double *corners, const std::vector<int32_t> &ids) {
  require(std::is_sorted(ids.begin(), ids.end()) && std::adjacent_find(ids.begin(), ids.end()) == ids.end(),
          scene.name + ": a row of a triangle does not ascend");
  for (size_t n = 0; n < scene.particles.count(); n++) {
    const oracle::Sphere particle{scene.particles.center(n), scene.particles.radii[n]};
    const double reach = particle.radius + scene.def.margin;
    double largest = 0;
    for (int k = 0; k < 9; k++) largest = std::max(largest, std::fabs(corners[k]));
    for (int k = 0; k < 3; k++) largest = std::max(largest, std::fabs(particle.center[k]));
    const bool found = std::binary_search(ids.begin(), ids.end(), static_cast<int32_t>(n) + scene.def.index_base);
    const oracle::Meeting truth = triangle_meeting(scene.def, corners, particle, 0x1p-40 * (reach + largest));
    const bool missed =
        truth == oracle::Meeting::kMeeting || (truth == oracle::Meeting::kTouching && scene.def.touching);
    require(found || !missed, scene.name + ": a triangle misses particle " + std::to_string(n));
    require(!found || truth != oracle::Meeting::kNone, scene.name + ": a triangle meets particle " + std::to_string(n));
  }
}

void check_triangles(Rng &rng, const Scene &scene, const Grid &grid) {
  const size_t count = 1 + rng.below(8);
  std::vector<double> corners(9 * count);
  for (size_t k = 0; k < count; k++) draw_triangle(rng, scene, &corners[9 * k]);
  if (scene.def.dimension == 2) {
    require(status_of([&] { grid.query_triangles(count, corners.data()); }) == HG_ERR_STATE, "triangles in a plane");
    return;
  }
  const hgrid::Rows rows = grid.query_triangles(count, corners.data());
  require(rows.size() == count, scene.name + ": the number of rows of triangles");
  for (size_t k = 0; k < count; k++) {
    if (!has_few_images(scene, &corners[9 * k], largest_reach(scene.def, scene.particles))) continue;
    check_triangle_row(scene, &corners[9 * k], list_of(rows[k]));
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
