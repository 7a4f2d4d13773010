// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Pairs that no rounded test can tell from touching: one unit in the last place around it, subnormal numbers, cell
// faces.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <cmath>
#include <limits>

namespace {

using namespace hgtest;

double step(double x, int ulps) {
  const double to = ulps < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  for (int k = 0; k < std::abs(ulps); k++) x = std::nextafter(x, to);
  return x;
}

// Two spheres whose distance is ra + rb up to a few units in the last place; many such pairs, far from each other.
void check_ulps(uint64_t seed) {
  Rng rng(seed);
  hg_grid_def def = hg_default_grid_def();
  def.thread_count = 1;
  def.dimension = rng.integer(2, 3);
  def.interaction = rng.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE;
  def.margin = rng.chance(0.5) ? 0 : rng.uniform();
  Particles particles;
  particles.dimension = def.dimension;
  for (int i = 0; i < 30; i++) {
    const double ra = rng.uniform(0.1, 1);
    const double rb = rng.chance(0.3) ? ra : rng.uniform(0.001, 1);
    const double reach = (def.interaction == HG_CONTACT ? ra + rb : std::fmax(ra, rb)) + def.margin;
    double u[3];
    double norm2 = 0;
    for (int k = 0; k < def.dimension; k++) {
      u[k] = rng.uniform(-1, 1);
      norm2 += u[k] * u[k];
    }
    double a[3];
    double b[3];
    for (int k = 0; k < def.dimension; k++) {
      a[k] = rng.uniform(-1, 1) + (k == 0 ? 16.0 * i : 0);
      b[k] = step(a[k] + reach * u[k] / std::sqrt(norm2), rng.integer(-2, 2));
    }
    particles.add(a, ra);
    particles.add(b, rb);
  }
  require_exact("ulps around touching", def, particles);
}
void ulps_around_touching(void **) { assert_true(sweep(400, check_ulps)); }

// Pythagorean quadruples: dx^2 + dy^2 + dz^2 = s^2 exactly, also scaled so far that the squares leave the doubles.
void check_quadruples(uint64_t seed) {
  constexpr int kQuadruples[][4] = {{1, 2, 2, 3}, {2, 3, 6, 7},  {4, 4, 7, 9},
                                    {1, 4, 8, 9}, {6, 6, 7, 11}, {3, 4, 0, 5}};
  constexpr double kScales[] = {1, 0x1p-30, 0x1p400, 0x1p-500, 0x1p530, 0x1p-560, 0x1p900, 0x1p-1000};
  Rng rng(seed);
  const double scale = kScales[seed % 8];
  hg_grid_def def = hg_default_grid_def();
  def.thread_count = 1;
  Particles particles;
  for (int i = 0; i < 24; i++) {
    const int *q = kQuadruples[rng.below(6)];
    const double a[3] = {64.0 * i * scale, rng.integer(-4, 4) * scale, rng.integer(-4, 4) * scale};
    double b[3];
    for (int k = 0; k < 3; k++) b[k] = a[k] + (rng.chance(0.5) ? q[k] : -q[k]) * scale;
    const int nudge = rng.integer(-1, 1);
    particles.add(a, step(1.0, nudge) * scale);
    particles.add(b, (q[3] - 1) * scale);
  }
  require_exact("quadruples", def, particles);
}
void exact_distances_at_every_scale(void **) { assert_true(sweep(240, check_quadruples)); }

// Subnormal coordinates and radii: all are integers times 2^-1074.
void check_subnormal(uint64_t seed) {
  Rng rng(seed);
  hg_grid_def def = hg_default_grid_def();
  def.dimension = rng.integer(2, 3);
  def.margin = rng.chance(0.5) ? 0 : 0x1p-1074;
  const int widest = rng.integer(1, 40);
  Particles particles;
  particles.dimension = def.dimension;
  for (int i = 0; i < 60; i++) {
    double x[3];
    for (double &coordinate : x) coordinate = rng.integer(-20, 20) * 0x1p-1074;
    particles.add(x, rng.integer(0, widest / 8) * 0x1p-1074);
  }
  if (rng.chance(0.3)) {
    const double far[3] = {1e300, -1e300, 1};
    particles.add(far, rng.chance(0.5) ? 1 : 0x1p-1074);
  }
  require_exact("subnormal", def, particles);
}
void subnormal_numbers(void **) { assert_true(sweep(150, check_subnormal)); }

// Equal spheres whose centres lie a few units in the last place from the faces of cells of edge 2 r, where a rounded
// division may put them one cell too far.
void check_faces(uint64_t seed) {
  Rng rng(seed);
  const double edge = rng.uniform(0.1, 1);
  const double cells[1] = {edge};
  hg_grid_def def = hg_default_grid_def();
  def.thread_count = 1;
  def.level_rule = HG_LEVELS_USER;
  def.level_count = 1;
  def.cell_sizes = cells;
  def.dimension = 2;
  Particles particles;
  particles.dimension = 2;
  for (int i = 0; i < 60; i++) {
    const int face = rng.integer(-1000000, 1000000);
    const double below[2] = {step(face * edge, rng.integer(-4, 1)), 100.0 * i * edge};
    const double above[2] = {step((face + 1) * edge, rng.integer(-4, 4)), 100.0 * i * edge};
    particles.add(below, 0.5 * edge);
    particles.add(above, 0.5 * edge);
  }
  require_exact("cell faces", def, particles);
}
void centres_near_cell_faces(void **) { assert_true(sweep(300, check_faces)); }

// One giant and three hundred particles a million times smaller, a third of them so dense that they meet each other.
void check_giant(uint64_t seed) {
  Rng rng(seed);
  Scene scene;
  const double origin[3] = {0, 0, 0};
  scene.particles.add(origin, 1);
  for (int i = 0; i < 300; i++) {
    double x[3];
    for (double &coordinate : x) coordinate = rng.uniform(-0.8, 0.8);
    if (i % 3 == 0) {
      for (double &coordinate : x) coordinate *= 1e-5;
    }
    scene.particles.add(x, 1e-6);
  }
  draw_levels(rng, scene);
  require_exact("giant", scene.def, scene.particles);
}
void one_giant_among_dust(void **) { assert_true(sweep(40, check_giant)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(ulps_around_touching), cmocka_unit_test(exact_distances_at_every_scale),
                              cmocka_unit_test(subnormal_numbers), cmocka_unit_test(centres_near_cell_faces),
                              cmocka_unit_test(one_giant_among_dust)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
