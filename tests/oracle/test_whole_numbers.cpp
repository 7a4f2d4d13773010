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
  const CMUnitTest tests[] = {cmocka_unit_test(open_scenes_agree), cmocka_unit_test(periodic_scenes_agree),
                              cmocka_unit_test(scenes_of_any_scale_agree), cmocka_unit_test(touching_spheres_agree)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
