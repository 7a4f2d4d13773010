// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The oracle against its second writing: rationals behind a filter of doubles against whole numbers without one, in
// scenes of every kind, and in sizes whose squares leave the range of doubles.
#include "tests/oracle/whole_numbers.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <cmath>

namespace {

using namespace hgtest;

constexpr size_t kMostParticles = 90;

void scale(Scene &scene, int power) {
  const auto times = [power](double &x) { x = std::ldexp(x, power); };
  for (double &x : scene.particles.centers) times(x);
  for (double &r : scene.particles.radii) times(r);
  for (double &x : scene.def.box_min) times(x);
  for (double &x : scene.def.box_max) times(x);
  for (double &x : scene.def.tilt) times(x);
  times(scene.def.margin);
}

void check(const Scene &scene) {
  const Pairs expected = whole_number_pairs(scene.def, scene.particles);
  require_same(scene.name.c_str(), all_pairs(scene.def, scene.particles, exact_interact), expected);
  if (scene.def.periodic[0] != 0) return;
  require_same((scene.name + ", swept").c_str(), swept_pairs(scene.def, scene.particles, exact_interact), expected);
}

void open_scenes_agree(void **) {
  assert_true(sweep(uint64_t{4} * kPlacesCount * kSizesCount, [](uint64_t s) {
    Rng rng(s);
    const auto places = static_cast<Places>(s % kPlacesCount);
    const auto sizes = static_cast<Sizes>(s / kPlacesCount % kSizesCount);
    check(open_scene(rng, 2 + static_cast<int>(rng.below(2)), rng.below(kMostParticles), sizes, places));
  }));
}

void periodic_scenes_agree(void **) {
  assert_true(sweep(uint64_t{2} * 7 * kSizesCount, [](uint64_t s) {
    Rng rng(s);
    const int axes = 1 + static_cast<int>(s % 7);
    const auto sizes = static_cast<Sizes>(s / 7 % kSizesCount);
    check(
        periodic_scene(rng, axes > 3 ? 3 : 2 + static_cast<int>(rng.below(2)), axes, rng.below(kMostParticles), sizes));
  }));
}

void tilted_scenes_agree(void **) {
  assert_true(sweep(uint64_t{20} * kSizesCount, [](uint64_t s) {
    Rng rng(s);
    const int dimension = rng.integer(2, 3);
    const auto sizes = static_cast<Sizes>(s % kSizesCount);
    Scene scene = tilted_scene(rng, dimension, draw_tilted_axes(rng, dimension), rng.below(kMostParticles), sizes);
    check(scene);
    scene.def.images = HG_ALL_IMAGES;
    check(scene);
  }));
}

void many_images_agree(void **) {
  assert_true(sweep(uint64_t{20} * kSizesCount, [](uint64_t s) {
    Rng rng(s);
    const int dimension = rng.integer(2, 3), axes = rng.integer(1, (1 << dimension) - 1);
    check(many_images_scene(rng, dimension, axes, rng.below(20), static_cast<Sizes>(s % kSizesCount)));
  }));
}

// Edges and places on a raster, so that many images touch exactly: flat and skewed cells, tilts of many lengths,
// reaches of many edges.
Scene raster_cell(Rng &rng) {
  Scene scene;
  scene.name = "raster";
  hg_grid_def &def = scene.def;
  def.dimension = scene.particles.dimension = rng.integer(2, 3);
  def.touching = rng.integer(0, 1);
  def.images = rng.integer(HG_NEAREST_IMAGE, HG_ALL_IMAGES);
  def.interaction = rng.integer(HG_CONTACT, HG_MAX_RANGE);
  def.margin = rng.integer(0, 1);
  const double unit = rng.chance(0.5) ? 0x1p-30 : 0.1;  // sums of tenths are rounded
  const double far = rng.chance(0.3) ? 1e6 * unit : 0;
  for (int k = 0; k < def.dimension; k++) {
    def.periodic[k] = 1;
    def.box_min[k] = far;
    def.box_max[k] = far + rng.integer(1, 12) * unit;
  }
  for (int k = 0; k < (def.dimension == 2 ? 1 : 3); k++) def.tilt[k] = rng.integer(-40, 40) * unit;
  def.margin *= unit;
  for (int i = 0; i < 8; i++) {
    double x[3];
    for (double &coordinate : x) coordinate = rng.integer(-60, 60) * unit;
    scene.particles.add(x, rng.integer(0, 5) * unit);
  }
  return scene;
}

void raster_cells_agree(void **) {
  assert_true(sweep(400, [](uint64_t seed) {
    Rng rng(seed);
    check(raster_cell(rng));
  }));
}

// Lattices whose number of nearest neighbours is known: one sphere in a cell, a pair with half of them.
void lattices_of_one_sphere(void **) {
  assert_true(holds(0, [](uint64_t) {
    struct Lattice {
      int dimension;
      double length[3], tilt[3], radius;
      size_t pairs;
    };
    // A square lattice of edge sqrt 2 on its corner, the face-centred cubic one with its 12 neighbours at sqrt 2, and
    // the simple cubic one under a tilt that leaves it as it is.
    const Lattice lattices[] = {
        {2, {2, 1, 0}, {1, 0, 0}, 0.75, 2}, {3, {2, 1, 1}, {1, 1, 0}, 0.71, 6}, {3, {1, 1, 1}, {7, -3, 2}, 0.5, 3}};
    for (const Lattice &lattice : lattices) {
      Scene scene;
      scene.name = "lattice of " + std::to_string(lattice.pairs);
      hg_grid_def &def = scene.def;
      def.dimension = scene.particles.dimension = lattice.dimension;
      def.images = HG_ALL_IMAGES;
      def.touching = 1;
      for (int k = 0; k < 3; k++) {
        def.periodic[k] = k < lattice.dimension ? 1 : 0;
        def.box_max[k] = lattice.length[k];
        def.tilt[k] = lattice.tilt[k];
      }
      const double center[3] = {0.3, 0.1, 0.2};
      scene.particles.add(center, lattice.radius);
      require_same(scene.name.c_str(), all_pairs(def, scene.particles, exact_interact),
                   Pairs(lattice.pairs, hg_pair{0, 0}));
      check(scene);
    }
  }));
}

// Squares that overflow, or round to nothing.
void scenes_of_any_scale_agree(void **) {
  for (const int power : {500, -480, -540, -1000}) {
    assert_true(sweep(kPlacesCount, [power](uint64_t seed) {
      Rng rng(seed);
      Scene scene = open_scene(rng, 3, kMostParticles, Sizes::kUniform, static_cast<Places>(seed));
      scale(scene, power);
      check(scene);
      scene = periodic_scene(rng, 3, 7, kMostParticles, Sizes::kUniform);
      scale(scene, power);
      check(scene);
      scene = tilted_scene(rng, 3, 7, kMostParticles, Sizes::kUniform);
      scale(scene, power);
      check(scene);
    }));
  }
}

// Two spheres that touch within rounding, in any direction: whether they overlap is left to the last digits.
Scene touching_spheres(Rng &rng) {
  Scene scene;
  scene.name = "touching";
  const double origin[3] = {0, 0, 0}, other[3] = {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
  const double radius = 0.5 * std::sqrt(other[0] * other[0] + other[1] * other[1] + other[2] * other[2]);
  scene.particles.add(origin, radius);
  scene.particles.add(other, radius);
  return scene;
}

// Rounded squares would not pass.
void touching_spheres_agree(void **) {
  assert_true(holds(1, [](uint64_t seed) {
    Rng rng(seed);
    int wrong = 0;
    for (int round = 0; round < 1000; round++) {
      const Scene scene = touching_spheres(rng);
      check(scene);
      const Pairs rounded = all_pairs(scene.def, scene.particles, double_interact);
      if (rounded.size() != whole_number_pairs(scene.def, scene.particles).size()) wrong++;
    }
    require(wrong > 50, "doubles decided " + std::to_string(1000 - wrong) + " of 1000");
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(open_scenes_agree),         cmocka_unit_test(periodic_scenes_agree),
                              cmocka_unit_test(tilted_scenes_agree),       cmocka_unit_test(many_images_agree),
                              cmocka_unit_test(raster_cells_agree),        cmocka_unit_test(lattices_of_one_sphere),
                              cmocka_unit_test(scenes_of_any_scale_agree), cmocka_unit_test(touching_spheres_agree)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
