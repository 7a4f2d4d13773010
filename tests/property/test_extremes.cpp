// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The ends of the range of doubles: squares that under- or overflow, extents whose ratio to the radii does, boxes so
// far from the origin that their coordinates are coarser than the box.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <cmath>

namespace {

using namespace hgtest;

// The exact set, and the plain expression with all that under- and overflow do to it.
void require_both(const std::string &what, hg_grid_def def, const Particles &particles) {
  def.accuracy = HG_EXACT;
  require_exact(what, def, particles);
  def.accuracy = HG_DOUBLE;
  require_same((what + ", HG_DOUBLE").c_str(), sorted_pairs_of(make_grid(def, particles)),
               all_pairs(def, particles, double_interact));
}

// Squares that vanish (1e-170) or overflow (1e160), and both in one set.
void check_scale(uint64_t seed, double scale, bool mixed) {
  Rng rng(seed);
  hg_grid_def def = hg_default_grid_def();
  def.dimension = rng.integer(2, 3);
  Particles particles;
  particles.dimension = def.dimension;
  for (int i = 0; i < 60; i++) {
    const double unit = mixed && rng.chance(0.5) ? 1 / scale : scale;
    double x[3];
    for (double &coordinate : x) coordinate = rng.uniform(-3, 3) * unit;
    particles.add(x, rng.uniform(0, 1) * unit);
  }
  require_both("scale " + std::to_string(std::log10(scale)), def, particles);
}
void squares_under_and_overflow(void **) {
  for (const double scale : {1e-170, 1e160, 1e-300, 1e300, 1e-320}) {
    assert_true(sweep(15, [=](uint64_t seed) {
      check_scale(seed, scale, false);
      if (scale != 1e-320) check_scale(seed, scale, true);
    }));
  }
}

// Some coordinates equal and enormous, the others ordinary: the extent is small, the offset is not.
void check_plane(uint64_t seed) {
  constexpr double kOffsets[] = {1e300, -1e300, 0x1p1023, 1e150, -1e16};
  Rng rng(seed);
  hg_grid_def def = hg_default_grid_def();
  Particles particles;
  const double offset = kOffsets[seed % 5];
  const double unit = seed % 2 == 0 ? 1 : 1e-9;
  for (int i = 0; i < 60; i++) {
    const double x[3] = {offset, rng.uniform(0, 6) * unit, seed % 3 == 0 ? offset : rng.uniform(0, 6) * unit};
    particles.add(x, rng.uniform(0, 1) * unit);
  }
  require_both("plane", def, particles);
}
void enormous_offsets(void **) { assert_true(sweep(60, check_plane)); }

// A single particle, or a few at one place, at the edge of the range; the others near the origin or nowhere.
void check_lonely(uint64_t seed) {
  constexpr double kPlaces[] = {1e300, -1e300, 0x1.fffffffffffffp1023, 0x1p-1074};
  constexpr double kRadii[] = {1e-9, 0, 0x1p-1074, 1, 1e300};
  Rng rng(seed);
  hg_grid_def def = hg_default_grid_def();
  Particles particles;
  const double far[3] = {kPlaces[rng.below(4)], kPlaces[rng.below(4)], kPlaces[rng.below(4)]};
  const int copies = rng.integer(1, 3);
  for (int i = 0; i < copies; i++) particles.add(far, kRadii[rng.below(5)]);
  const int others = rng.integer(0, 2) * 20;
  for (int i = 0; i < others; i++) {
    const double x[3] = {rng.uniform(0, 1e-8), rng.uniform(0, 1e-8), rng.uniform(0, 1e-8)};
    particles.add(x, kRadii[rng.below(3)]);
  }
  require_both("lonely", def, particles);
}
void lonely_at_the_edge(void **) { assert_true(sweep(120, check_lonely)); }

// A crowd of dust, and giants from one end of the doubles to the other, or nearly, as wide as doubles allow or less.
void check_giants_at_both_ends(uint64_t seed) {
  Rng rng(seed);
  hg_grid_def def = hg_default_grid_def();
  def.dimension = rng.integer(2, 3);
  const double giant = std::pow(10, rng.uniform(290, 307.95)), dust = giant * std::pow(10, -rng.uniform(8, 20));
  const double cells[2] = {2 * dust, 2 * giant};
  def.level_rule = HG_LEVELS_USER;
  def.level_count = 2;
  def.cell_sizes = cells;
  Particles particles;
  particles.dimension = def.dimension;
  for (int i = 0; i < 150; i++) {
    double x[3];
    for (double &coordinate : x) coordinate = rng.uniform(-5, 5) * dust;
    particles.add(x, rng.uniform(0, 1) * dust);
  }
  const double far = std::min(giant * std::pow(10, rng.uniform(0, 3)), 1.79e308);
  for (int i = 0; i < 12; i++) {
    double x[3];
    for (double &coordinate : x) coordinate = far * (rng.chance(0.5) ? rng.uniform(-1, 1) : rng.integer(-1, 1));
    particles.add(x, giant);
  }
  require_both("giants", def, particles);
}
void giants_at_both_ends(void **) { assert_true(sweep(200, check_giants_at_both_ends)); }

// A box of length 1 at 2^e, tilted or not: coordinates in it are multiples of 2^(e - 52), those far below it are finer.
// Pairs touch up to a few of these, in the box and through its faces.
void check_far_box(uint64_t seed) {
  Rng rng(seed);
  hg_grid_def def = hg_default_grid_def();
  def.thread_count = 1;
  const int exponent = rng.integer(20, 40);
  const double quantum = std::ldexp(1, exponent - 52);
  const double start = std::ldexp(rng.chance(0.5) ? 1 : -1, exponent);
  def.periodic[0] = 1;
  def.box_min[0] = start;
  def.box_max[0] = start + 1;
  if (rng.chance(0.5)) {
    def.periodic[1] = 1;
    def.box_max[1] = 200;
    def.tilt[0] = rng.integer(-99, 99) * 0.25;
  }
  const int spread = rng.integer(2, 12);
  Particles particles;
  for (int i = 0; i < 40; i++) {
    const double s = std::ldexp(1, -rng.integer(4, 10)) - rng.integer(-2, 2) * quantum / 2;
    const double y = 4.0 * i;
    const double low[3] = {start + rng.integer(-spread, spread) * quantum * 0.5, y, 0};
    const double high[3] = {low[0] + rng.integer(-3, 3) + (rng.chance(0.5) ? s : -s) + rng.integer(-2, 2) * quantum, y,
                            0};
    particles.add(low, s / 2);
    particles.add(high, s / 2);
  }
  require_both("far box", def, particles);
}
void boxes_far_from_the_origin(void **) { assert_true(sweep(400, check_far_box)); }

// Particles far out along an open axis make the coordinates of the search coarser than the periodic box, through whose
// faces others still meet.
void check_open_outlier(uint64_t seed) {
  Rng rng(seed);
  Scene scene;
  scene.name = "outlier along an open axis";
  hg_grid_def &def = scene.def;
  def.dimension = scene.particles.dimension = rng.integer(2, 3);
  def.periodic[0] = 1;
  def.box_max[0] = rng.uniform(5, 20);
  if (def.dimension == 3 && rng.chance(0.5)) {
    def.periodic[1] = 1;
    def.box_max[1] = 10;
    def.tilt[0] = rng.chance(0.5) ? rng.uniform(-20, 20) : 0;
  }
  def.images = rng.chance(0.3) ? HG_ALL_IMAGES : HG_NEAREST_IMAGE;
  const size_t count = rng.chance(0.5) ? 60 : 2 + rng.below(10);
  for (size_t i = 0; i < count; i++) {
    const double x[3] = {rng.uniform(-20, 40), rng.uniform(0, 10), rng.uniform(0, 5)};
    scene.particles.add(x, rng.uniform(0, 1));
  }
  for (int i = 0; i < 3; i++) {
    double x[3] = {rng.uniform(0, 5), rng.uniform(0, 5), rng.uniform(0, 5)};
    x[def.dimension - 1] = std::pow(10, rng.uniform(6, 120)) * (rng.chance(0.5) ? 1 : -1);
    scene.particles.add(x, 1);
  }
  require_both(scene.name, def, scene.particles);
  const Grid grid = make_grid(def, scene.particles);
  const double *center = scene.particles.center(rng.below(count));
  const hgrid::View<int32_t> ids = grid.query_sphere(center, 1);
  require_same("sphere", std::vector<int32_t>(ids.begin(), ids.end()),
               all_in_sphere(def, scene.particles, {center, 1}, exact_interact));
}
void outliers_along_an_open_axis(void **) { assert_true(sweep(100, check_open_outlier)); }

// Two that meet through a face, and one so far away that the box is shorter than the search can tell places apart.
void a_face_finer_than_the_search(void **) {
  assert_true(sweep(40, [](uint64_t exponent) {
    hg_grid_def def = hg_default_grid_def();
    def.periodic[0] = 1;
    def.box_max[0] = 99;
    Particles particles;
    for (const double x : {0.5, 98.5}) {
      const double near[3] = {x, 0, 0};
      particles.add(near, 1);
    }
    const double far[3] = {5, std::pow(10, static_cast<double>(exponent)), 0};
    particles.add(far, 1);
    require_both("outlier at 1e" + std::to_string(exponent), def, particles);
  }));
}

// A box that is shorter than two reaches by less than its rounded length shows: refused, or handled fully.
void box_short_by_less_than_rounding(void **) {
  assert_true(holds(0, [](uint64_t) {
    hg_grid_def def = hg_default_grid_def();
    def.periodic[0] = 1;
    def.box_min[0] = 0x1p-55;
    def.box_max[0] = 1;
    Particles particles;
    const double a[3] = {0.25, 0, 0};
    const double b[3] = {0.75, 0, 0};
    particles.add(a, 0.25);
    particles.add(b, 0.25);
    Grid grid(def);
    const hg_status status = status_of([&] { grid.insert(2, particles.centers.data(), particles.radii.data()); });
    if (status == HG_ERR_ARGUMENT) return;
    require(status == HG_OK, hg_last_error());
    require_same("short box", pairs_of(grid), all_pairs(def, particles, exact_interact));
  }));
}

// A reach that is no double: refused, and the grid stays usable.
void reach_overflows(void **) {
  assert_true(holds(0, [](uint64_t) {
    Grid grid;
    const double centers[6] = {0, 0, 0, 1, 0, 0};
    const double huge[2] = {1e308, 1};
    const double fine[2] = {1, 1};
    const hg_status status = status_of([&] { grid.insert(2, centers, huge); });
    require(status == HG_ERR_LIMIT || status == HG_ERR_ARGUMENT, "an overflowing reach is accepted");
    grid.insert(2, centers, fine);
    require_same("after the refusal", pairs_of(grid), {{0, 1}});
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(squares_under_and_overflow),
                              cmocka_unit_test(enormous_offsets),
                              cmocka_unit_test(lonely_at_the_edge),
                              cmocka_unit_test(giants_at_both_ends),
                              cmocka_unit_test(boxes_far_from_the_origin),
                              cmocka_unit_test(a_face_finer_than_the_search),
                              cmocka_unit_test(outliers_along_an_open_axis),
                              cmocka_unit_test(box_short_by_less_than_rounding),
                              cmocka_unit_test(reach_overflows)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
