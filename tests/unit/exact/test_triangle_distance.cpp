// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How far points are from triangles, against rational numbers: of any shape down to needles as thin as coordinates are
// rounded, of any size, and from points in the plane to points very far away.
#include "oracle/shapes.hpp"
#include "src/exact/triangle_distance.hpp"
#include "tests/unit/checks.hpp"

#include <algorithm>
#include <cmath>

namespace {

using namespace hgtest;

void draw_corners(Rng &rng, double unit, double *corners) {
  const double far = rng.chance(0.3) ? 1e6 * unit : 0;
  for (int k = 0; k < 9; k++) corners[k] = far + unit * rng.uniform(-1, 1);
  const uint64_t kind = rng.below(4);
  if (kind == 0) {
    // A needle, of which any corner may be the middle one.
    const double t = rng.uniform(-1, 2), off = unit * std::pow(2, rng.uniform(-60, -10));
    for (int k = 0; k < 3; k++)
      corners[6 + k] = corners[k] + t * (corners[3 + k] - corners[k]) + off * rng.uniform(-1, 1);
  } else if (kind == 1) {
    const double off = unit * std::pow(2, rng.uniform(-60, -10));
    for (int k = 0; k < 3; k++) corners[6 + k] = corners[k] + off * rng.uniform(-1, 1);
  } else if (kind == 2 && rng.chance(0.2)) {
    std::copy_n(corners, 3, corners + 3 * (1 + rng.below(2)));
  }
}

// Near an edge or a corner, above it by any height; or anywhere.
void draw_point(Rng &rng, double unit, const double *corners, double *point) {
  const double far = std::min(unit * std::pow(10, rng.chance(0.1) ? rng.uniform(0, 300) : rng.uniform(-12, 1)), 1e300);
  double weight[3] = {rng.uniform(), rng.uniform(), rng.chance(0.5) ? 0 : rng.uniform()};
  if (rng.chance(0.2)) weight[1] = weight[2] = 0;
  const double sum = weight[0] + weight[1] + weight[2];
  for (int axis = 0; axis < 3; axis++) {
    point[axis] = far * rng.uniform(-1, 1);
    for (int k = 0; k < 3; k++) point[axis] += corners[3 * k + axis] * weight[k] / sum;
  }
}

void check_points(uint64_t seed) {
  Rng rng(seed);
  hg_grid_def def{};
  def.dimension = 3;
  const double unit = std::ldexp(1, rng.chance(0.8) ? rng.integer(-20, 20) : rng.integer(-1000, 600));
  double corners[9], point[3];
  draw_corners(rng, unit, corners);
  const hg::Triangle triangle(corners);
  for (int k = 0; k < 30; k++) {
    draw_point(rng, unit, corners, point);
    double largest = 0;
    for (const double x : corners) largest = std::max(largest, std::fabs(x));
    for (const double x : point) largest = std::max(largest, std::fabs(x));
    const double error = 0x1p-45 * largest, distance = triangle.distance(point);
    require(triangle.size() <= largest, "the size %g", triangle.size());
    require(oracle::triangle_meeting(def, corners, {point, distance + error}, 0) >= oracle::Meeting::kTouching,
            "farther than %.17g, which may be off by %g", distance, error);
    require(distance <= error ||
                oracle::triangle_meeting(def, corners, {point, distance - error}, 0) <= oracle::Meeting::kTouching,
            "nearer than %.17g, which may be off by %g", distance, error);
  }
}
void points_anywhere(void **) { assert_true(sweep(1500, check_points)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(points_anywhere)};
  return cmocka_run_group_tests_name("triangle_distance", tests, nullptr, nullptr);
}
