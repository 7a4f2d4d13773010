// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// def.touching: spheres that touch exactly are pairs. Lattices of them, points at one place, faces of periodic boxes,
// pairs up to one unit in the last place from touching, and the shortest box, where two images touch.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace {

using namespace hgtest;

hg_grid_def touching_def() {
  hg_grid_def def = hg_default_grid_def();
  def.touching = 1;
  return def;
}

// Where squares are whole numbers, doubles give the same; floats may give more.
void require_pairs(const char *what, hg_grid_def def, const Particles &particles, const Pairs &expected) {
  for (def.accuracy = HG_EXACT; def.accuracy <= HG_DOUBLE; def.accuracy++) {
    require_same(what, sorted_pairs_of(make_grid(def, particles)), expected);
  }
  def.accuracy = HG_FLOAT;
  const Pairs found = sorted_pairs_of(make_grid(def, particles));
  require(std::includes(found.begin(), found.end(), expected.begin(), expected.end(), pair_less),
          std::string(what) + ": HG_FLOAT misses a pair");
}

void require_number(const char *what, const hg_grid_def &def, const Particles &particles, size_t count) {
  const Pairs expected = all_pairs(def, particles, exact_interact);
  require(expected.size() == count, std::string(what) + ": " + std::to_string(expected.size()) + " pairs are expected");
  require_pairs(what, def, particles, expected);
}

Particles cubic_lattice(int side, double unit) {
  Particles particles;
  for (int at = 0; at < side * side * side; at++) {
    const double center[3] = {at % side * unit, at / side % side * unit, static_cast<double>(at / side / side) * unit};
    particles.add(center, 0.5 * unit);
  }
  return particles;
}

// Each sphere touches six others: in the box if its axes are open, through its faces if they are periodic, also under a
// tilt of whole spacings. Two spheres in a row touch through both faces and are one pair, or two with HG_ALL_IMAGES.
void cubic_lattices(void **) {
  assert_true(holds(0, [](uint64_t) {
    for (const double unit : {1.0, 0x1p-30, 0x1.8p20}) {
      for (const size_t side : {2u, 3u, 5u}) {
        hg_grid_def def = touching_def();
        const Particles particles = cubic_lattice(static_cast<int>(side), unit);
        const size_t all = side * side * side;
        require_number("open", def, particles, 3 * side * side * (side - 1));
        for (int k = 0; k < 3; k++) {
          def.periodic[k] = 1;
          def.box_max[k] = static_cast<double>(side) * unit;
        }
        require_number("periodic", def, particles, side == 2 ? 12 : 3 * all);
        def.images = HG_ALL_IMAGES;
        require_number("all images", def, particles, 3 * all);
        def.tilt[0] = unit;
        def.tilt[1] = -2 * unit;
        def.tilt[2] = 4 * unit;
        require_number("tilted, all images", def, particles, 3 * all);
        def.images = HG_NEAREST_IMAGE;
        if (side > 2) require_number("tilted", def, particles, 3 * all);
        def.touching = 0;
        require_number("strict", def, particles, 0);
      }
    }
  }));
}

// Without size, particles at one place touch each other, wherever they were put into the box.
void points_at_one_place(void **) {
  assert_true(holds(0, [](uint64_t) {
    hg_grid_def def = touching_def();
    Particles points;
    for (const double x : {0.0, -0.0, 0.0, 0x1p-30, 3.0, 3.0, -3.0}) {
      const double center[3] = {x, 0, -x};
      points.add(center, 0);
    }
    require_pairs("points", def, points, {{0, 1}, {0, 2}, {1, 2}, {4, 5}});
    for (int k = 0; k < 3; k++) {
      def.periodic[k] = 1;
      def.box_max[k] = 3;
    }
    const Pairs on_faces = {{0, 1}, {0, 2}, {0, 4}, {0, 5}, {0, 6}, {1, 2}, {1, 4}, {1, 5},
                            {1, 6}, {2, 4}, {2, 5}, {2, 6}, {4, 5}, {4, 6}, {5, 6}};
    require_pairs("points on faces", def, points, on_faces);
    def.tilt[0] = 30;
    def.tilt[2] = -6;
    require_pairs("points on tilted faces", def, points, on_faces);
    def.images = HG_ALL_IMAGES;
    require_pairs("all images of points", def, points, on_faces);
  }));
}

double step(double x, int ulps) { return ulps == 0 ? x : std::nextafter(x, ulps > 0 ? 2 * x : 0); }

// dx^2 + dy^2 + dz^2 = s^2 in whole numbers, at scales that take the squares out of the doubles as well, one of the
// spheres larger or smaller by a unit in the last place, or not.
void check_quadruples(uint64_t seed) {
  constexpr int kQuadruples[][4] = {{1, 2, 2, 3}, {2, 3, 6, 7},  {4, 4, 7, 9},
                                    {1, 4, 8, 9}, {6, 6, 7, 11}, {3, 4, 0, 5}};
  constexpr double kScales[] = {1, 0x1p-30, 0x1p400, 0x1p-500, 0x1p530, 0x1p-560, 0x1p900, 0x1p-1000};
  Rng rng(seed);
  const double scale = kScales[seed % 8];
  hg_grid_def def = touching_def();
  def.thread_count = 1;
  if (rng.chance(0.3)) {
    for (int k = 0; k < 3; k++) {
      def.periodic[k] = 1;
      def.box_max[k] = 64 * 24 * scale;
      def.tilt[k] = rng.integer(-200, 200) * scale;
    }
  }
  Particles particles;
  for (int i = 0; i < 24; i++) {
    const int *q = kQuadruples[rng.below(6)];
    const double a[3] = {64.0 * i * scale, rng.integer(-4, 4) * scale, rng.integer(-4, 4) * scale};
    double b[3];
    for (int k = 0; k < 3; k++) b[k] = a[k] + (rng.chance(0.5) ? q[k] : -q[k]) * scale;
    particles.add(a, step(1, rng.integer(-1, 1)) * scale);
    particles.add(b, (q[3] - 1) * scale);
  }
  require_exact("quadruples", def, particles);
}
void touching_at_every_scale(void **) { assert_true(sweep(240, check_quadruples)); }

// Spheres that touch up to rounding, in any direction: HG_DOUBLE has those whose rounded squares are equal, too.
void check_double(uint64_t seed) {
  Rng rng(seed);
  hg_grid_def def = touching_def();
  def.accuracy = HG_DOUBLE;
  def.margin = rng.chance(0.5) ? 0 : 0.125;
  Particles particles;
  for (int i = 0; i < 60; i++) {
    const double r = rng.uniform(0.1, 1), s = rng.uniform(0.1, 1), angle = rng.uniform(0, 6.28);
    const double a[3] = {16.0 * i + rng.uniform(), rng.uniform(), rng.uniform()};
    const double reach = r + s + def.margin;
    const double b[3] = {a[0] + reach * std::cos(angle), a[1] + reach * std::sin(angle), a[2]};
    particles.add(a, r);
    particles.add(b, s);
  }
  require_same("in doubles", sorted_pairs_of(make_grid(def, particles)), all_pairs(def, particles, double_interact));
  require_exact("touching up to rounding", touching_def(), particles);
}
void touching_up_to_rounding(void **) { assert_true(sweep(200, check_double)); }

// A sphere that touches a particle finds it, by the same rule; also at a point.
void spheres_that_touch(void **) {
  assert_true(holds(0, [](uint64_t) {
    hg_grid_def def = touching_def();
    const Grid grid = make_grid(def, cubic_lattice(4, 1));
    const double middle[3] = {0.5, 0.5, 0.5}, between[3] = {0.5, 1, 1}, centre[3] = {1, 1, 1};
    const auto found = [&](const double *center, double radius) { return grid.query_sphere(center, radius).size(); };
    require(found(between, 0) == 2, "a point between two spheres");
    require(found(centre, 0) == 1, "a point in the middle of a sphere");
    require(found(centre, 0.5) == 7, "a sphere in place of another");
    require(found(middle, 0.25) == 0 && found(middle, 0.5) == 8, "a sphere in the middle of eight");
    require(found(centre, std::nextafter(0.5, 0)) == 1,
            "a sphere that is not large enough by a unit in the last place");
  }));
}

// Boxes just as long as two reaches: particles half a box apart touch through both faces, and are one pair.
void half_a_box_apart(void **) {
  assert_true(sweep(60, [](uint64_t seed) {
    Rng rng(seed);
    hg_grid_def def = touching_def();
    def.dimension = rng.integer(2, 3);
    Particles particles;
    particles.dimension = def.dimension;
    const double low = 0.25 * rng.integer(-99, 99);
    for (int k = 0; k < def.dimension; k++) {
      def.periodic[k] = 1;
      def.box_min[k] = low;
      def.box_max[k] = low + 4;
    }
    if (rng.chance(0.5)) def.tilt[0] = rng.integer(-9, 9) * 0.5;
    for (int i = 0; i < 30; i++) {
      double x[3];
      for (double &coordinate : x) coordinate = rng.integer(-40, 40) * 0.5;
      particles.add(x, 1);
    }
    require_pairs("half a box", def, particles, all_pairs(def, particles, exact_interact));
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(cubic_lattices),          cmocka_unit_test(points_at_one_place),
                              cmocka_unit_test(touching_at_every_scale), cmocka_unit_test(touching_up_to_rounding),
                              cmocka_unit_test(spheres_that_touch),      cmocka_unit_test(half_a_box_apart)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
