// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Tilted cells: HG_EXACT, HG_DOUBLE and HG_FLOAT with any tilt and level rule, flat and skewed cells, the shortest cell
// that is allowed, near ties across the faces, and the same lattice by other edges.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <cmath>
#include <initializer_list>
#include <iterator>

namespace {

using namespace hgtest;

void require_accuracy(Scene &scene, int32_t accuracy) {
  scene.def.accuracy = accuracy;
  const Pairs exact = all_pairs(scene.def, scene.particles, exact_interact);
  const Pairs found = sorted_pairs_of(make_grid(scene.def, scene.particles));
  if (accuracy == HG_FLOAT) {
    require_superset(scene.name, scene.def, scene.particles, found, exact);
  } else if (accuracy == HG_EXACT) {
    require_same(scene.name.c_str(), found, exact);
  } else {
    require_same((scene.name + ", HG_DOUBLE").c_str(), found, all_pairs(scene.def, scene.particles, double_interact));
  }
}

template <int32_t accuracy>
void any_tilt(void **) {
  assert_true(sweep(accuracy == HG_EXACT ? 700 : 350, [](uint64_t seed) {
    Rng rng(seed + 1000 * accuracy);
    const int dimension = rng.integer(2, 3);
    const size_t count = rng.chance(0.1) ? rng.below(4) : rng.below(251);
    Scene scene = tilted_scene(rng, dimension, draw_tilted_axes(rng, dimension), count,
                               static_cast<Sizes>(rng.below(kSizesCount)));
    draw_levels(rng, scene);
    require_accuracy(scene, accuracy);
  }));
}

// The largest radius that two particles may have, but for rounding.
double largest_radius(const hg_grid_def &def) {
  Particles two;
  two.dimension = def.dimension;
  two.centers.resize(6);
  double low = 0, high = 0.25 * (def.box_max[0] - def.box_min[0]);
  for (int step = 0; step < 50; step++) {
    const double middle = 0.5 * (low + high);
    two.radii.assign(2, middle);
    (can_meet_twice(def, two) ? high : low) = middle;
  }
  return low;
}

// Cells much lower than their longest edge, which the tilt keeps the images apart in: heights and widths say nothing of
// how near images are.
void check_flat_cell(uint64_t seed) {
  Rng rng(seed);
  Scene scene;
  scene.name = "flat cell";
  hg_grid_def &def = scene.def;
  def.dimension = scene.particles.dimension = rng.integer(2, 3);
  def.accuracy = rng.chance(0.7) ? HG_EXACT : HG_DOUBLE;
  double length = std::ldexp(1, rng.integer(-20, 20));
  for (int k = 0; k < def.dimension; k++) {
    def.periodic[k] = 1;
    def.box_min[k] = rng.uniform(-1, 1) * length;
    def.box_max[k] = def.box_min[k] + length;
    length *= rng.uniform(0.05, 1);
  }
  const double lx = def.box_max[0] - def.box_min[0], ly = def.box_max[1] - def.box_min[1];
  def.tilt[0] = rng.uniform(-1.5, 1.5) * lx;
  if (def.dimension == 3) {
    def.tilt[1] = rng.uniform(-1.5, 1.5) * lx;
    def.tilt[2] = rng.uniform(-1.5, 1.5) * ly;
  }
  const double largest = largest_radius(def);
  for (int i = 0; i < 60; i++) {
    double x[3] = {def.box_min[0], def.box_min[1], def.box_min[2]};
    const double n[3] = {rng.uniform(-2, 2), rng.uniform(-2, 2), rng.uniform(-2, 2)};
    move_by_cells(def, n, x);
    scene.particles.add(x, largest * (rng.chance(0.5) ? 1 : rng.uniform()));
  }
  draw_levels(rng, scene);
  require_accuracy(scene, def.accuracy);
}
void flat_and_skewed_cells(void **) { assert_true(sweep(500, check_flat_cell)); }

// Whole numbers: the shortest vector of the lattice, here with a whole length, is just 2 (r1 + r2 + margin).
struct ShortestCell {
  int dimension;
  double length[3], tilt[3], shortest;
};
constexpr ShortestCell kShortestCells[] = {
    {2, {7, 4, 0}, {3, 0, 0}, 5},       {2, {7, 4, 0}, {-4, 0, 0}, 5}, {2, {7, 4, 0}, {3 + 7 * 9, 0, 0}, 5},
    {2, {50, 4, 0}, {-47, 0, 0}, 5},    {3, {8, 6, 2}, {1, 1, 2}, 3},  {3, {8, 6, 2}, {1 - 8 * 5, 16, -4}, 3},
    {3, {5, 5, 5}, {2.5, 2.5, 2.5}, 5}, {3, {10, 7, 2}, {3, 2, 1}, 3}, {3, {12, 6, 6}, {60, -24, 12}, 6},
};

// Particles on a raster, so that pairs touch through two images, and others nearly.
void check_shortest_cell(uint64_t seed) {
  Rng rng(seed);
  const ShortestCell &cell = kShortestCells[seed % std::size(kShortestCells)];
  const double unit = std::ldexp(1, rng.integer(-30, 30));
  Scene scene;
  scene.name = "shortest cell " + std::to_string(seed % std::size(kShortestCells));
  hg_grid_def &def = scene.def;
  def.dimension = scene.particles.dimension = cell.dimension;
  def.touching = rng.integer(0, 1);
  def.interaction = rng.integer(HG_CONTACT, HG_MAX_RANGE);
  for (int k = 0; k < cell.dimension; k++) {
    def.periodic[k] = 1;
    def.box_min[k] = rng.integer(-3, 3) * unit;
    def.box_max[k] = def.box_min[k] + cell.length[k] * unit;
    def.tilt[k] = cell.dimension == 3 || k == 0 ? cell.tilt[k] * unit : 0;
  }
  const double half = 0.5 * cell.shortest * unit;  // r1 + r2 + margin, or the largest range
  def.margin = rng.chance(0.5) ? 0 : 0.25 * half;
  const double largest = (def.interaction == HG_CONTACT ? 0.5 : 1) * (half - def.margin);
  for (int i = 0; i < 50; i++) {
    double x[3];
    for (double &coordinate : x) coordinate = 0.5 * rng.integer(-40, 40) * unit;
    scene.particles.add(x, i < 2 || rng.chance(0.6) ? largest : std::nextafter(largest, 0));
  }
  draw_levels(rng, scene);
  require(!can_meet_twice(def, scene.particles), "the cell is too short");
  require_accuracy(scene, rng.integer(HG_EXACT, HG_DOUBLE));
  scene.particles.radii[1] = std::nextafter(scene.particles.radii[1], 2 * half);
  require(can_meet_twice(def, scene.particles), "the cell is not too short");
  require(status_of([&] { make_grid(def, scene.particles); }) == HG_ERR_ARGUMENT, "a cell too short is taken");
}
void shortest_cells(void **) { assert_true(sweep(40 * std::size(kShortestCells), check_shortest_cell)); }

// The edge (3, 4) of which the 4 lacks less than its rounded length shows.
void short_by_less_than_rounding(void **) {
  assert_true(holds(0, [](uint64_t) {
    hg_grid_def def = hg_default_grid_def();
    def.periodic[0] = def.periodic[1] = 1;
    def.box_max[0] = 7;
    def.box_max[1] = 4;
    def.tilt[0] = 3;
    Particles particles;
    const double a[3] = {0, 0, 0}, b[3] = {1.5, 2, 0};
    particles.add(a, 1.25);
    particles.add(b, 1.25);
    require_exact("just long enough", def, particles);
    def.touching = 1;
    require_exact("just long enough, touching", def, particles);
    def.box_min[1] = 0x1p-55;
    require(def.box_max[1] - def.box_min[1] == 4, "the length is not rounded");
    require(status_of([&] { make_grid(def, particles); }) == HG_ERR_ARGUMENT, "a cell too short is taken");
  }));
}

// Pairs that touch, up to a few units in the last place, the one seen through a tilted face, edge or corner, in a cell
// whose lengths are no doubles.
void check_face(uint64_t seed) {
  Rng rng(seed);
  Scene scene;
  scene.name = "across a tilted face";
  hg_grid_def &def = scene.def;
  def.thread_count = 1;
  def.dimension = scene.particles.dimension = rng.integer(2, 3);
  const int axes = draw_tilted_axes(rng, def.dimension);
  const double far = rng.chance(0.3) ? std::ldexp(1, rng.integer(5, 30)) : 0;
  for (int k = 0; k < def.dimension; k++) {
    def.periodic[k] = axes >> k & 1;
    def.box_min[k] = far + rng.uniform(-0.1, 0);
    def.box_max[k] = far + rng.uniform(2, 3);
  }
  const double most = rng.chance(0.5) ? 1 : 100;
  if (def.periodic[0] + def.periodic[1] == 2) def.tilt[0] = rng.uniform(-most, most);
  if (def.periodic[0] + def.periodic[2] == 2) def.tilt[1] = rng.uniform(-most, most);
  if (def.periodic[1] + def.periodic[2] == 2) def.tilt[2] = rng.uniform(-most, most);
  for (int i = 0; i < 60; i++) {
    const double r = rng.uniform(0.01, 0.1), s = rng.uniform(0.01, 0.1);
    double a[3], b[3], direction[3], square = 0;
    for (int k = 0; k < def.dimension; k++) {
      direction[k] = rng.uniform(-1, 1);
      square += direction[k] * direction[k];
      a[k] = def.box_min[k] + (rng.chance(0.5) ? rng.uniform(0, 0.05) : rng.uniform(0, 2));
    }
    for (int k = 0; k < def.dimension; k++) b[k] = a[k] + (r + s) * direction[k] / std::sqrt(square);
    const double n[3] = {1.0 * rng.integer(-4, 4), 1.0 * rng.integer(-2, 2), 1.0 * rng.integer(-2, 2)};
    move_by_cells(def, n, b);
    b[0] += rng.integer(-3, 3) * (std::nextafter(b[0], 1e300) - b[0]);
    scene.particles.add(a, r);
    scene.particles.add(b, s);
  }
  require_accuracy(scene, HG_EXACT);
  require_accuracy(scene, HG_DOUBLE);
}
void near_ties_across_tilted_faces(void **) { assert_true(sweep(400, check_face)); }

// b + n a and c + n a + m b are edges of the same lattice: with whole numbers not a pair changes.
void check_same_lattice(uint64_t seed) {
  Rng rng(seed);
  hg_grid_def def = hg_default_grid_def();
  Particles particles;
  const double unit = 0x1p-10;
  double length[3];
  for (int k = 0; k < 3; k++) {
    def.periodic[k] = 1;
    length[k] = rng.integer(900, 1200) * unit;
    def.box_max[k] = length[k];
    def.tilt[k] = rng.integer(-600, 600) * unit;
  }
  for (int i = 0; i < 200; i++) {
    const double x[3] = {rng.integer(-1000, 2000) * unit, rng.integer(-1000, 2000) * unit,
                         rng.integer(-1000, 2000) * unit};
    particles.add(x, rng.integer(1, 210) * unit);
  }
  const Pairs expected = sorted_pairs_of(make_grid(def, particles));
  require(expected.size() > 50, "too few pairs for a test");
  for (int round = 0; round < 3; round++) {
    def.tilt[0] += rng.integer(-9, 9) * length[0];
    const int m = rng.integer(-9, 9);
    def.tilt[1] += m * def.tilt[0] + rng.integer(-9, 9) * length[0];
    def.tilt[2] += m * length[1];
    require_same("the same lattice", sorted_pairs_of(make_grid(def, particles)), expected);
  }
}
void other_edges_of_the_same_lattice(void **) { assert_true(sweep(60, check_same_lattice)); }

// Tilts of a half million lengths: doubles are coarse there, the pairs are not. More than 2^20 are refused.
void largest_tilt(void **) {
  assert_true(holds(0, [](uint64_t seed) {
    Rng rng(seed);
    hg_grid_def def = hg_default_grid_def();
    def.periodic[0] = def.periodic[1] = 1;
    def.box_max[0] = 4.1;
    def.box_max[1] = 5;
    Particles particles;
    for (int i = 0; i < 150; i++) {
      const double x[3] = {rng.uniform(-9, 9), rng.uniform(-1, 6), rng.uniform(0, 1)};
      particles.add(x, rng.uniform(0, 0.5));
    }
    for (const double sign : {1.0, -1.0}) {
      def.tilt[0] = sign * (0x1p19 - 100) * 4.1;
      require_exact("largest tilt", def, particles);
      def.tilt[0] = std::nextafter(def.tilt[0], 0);
      require_exact("all but the largest tilt", def, particles);
      def.tilt[0] = sign * 0x1p20 * 4.2;
      require(status_of([&] { const Grid grid(def); }) != HG_OK, "a larger tilt is taken");
    }
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_tilt<HG_EXACT>),
                              cmocka_unit_test(any_tilt<HG_DOUBLE>),
                              cmocka_unit_test(any_tilt<HG_FLOAT>),
                              cmocka_unit_test(flat_and_skewed_cells),
                              cmocka_unit_test(shortest_cells),
                              cmocka_unit_test(short_by_less_than_rounding),
                              cmocka_unit_test(near_ties_across_tilted_faces),
                              cmocka_unit_test(other_edges_of_the_same_lattice),
                              cmocka_unit_test(largest_tilt)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
