// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hg_overlap against exact arithmetic: two spheres of any size, through any image, in any box.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <algorithm>

namespace {

using namespace hgtest;

Scene draw(Rng &rng) {
  const int dimension = rng.integer(2, 3);
  const auto sizes = static_cast<Sizes>(rng.below(kSizesCount));
  switch (rng.below(4)) {
    case 0:
      return open_scene(rng, dimension, 40, sizes, static_cast<Places>(rng.below(kPlacesCount)));
    case 1:
      return periodic_scene(rng, dimension, rng.integer(1, (1 << dimension) - 1), 40, sizes);
    case 2:
      return tilted_scene(rng, dimension, draw_tilted_axes(rng, dimension), 40, sizes);
    default:
      return many_images_scene(rng, dimension, rng.integer(1, (1 << dimension) - 1), 20, sizes);
  }
}

// Particles with each other, and with copies of them that are moved, larger or smaller.
template <int32_t accuracy>
void any_two_spheres(void **) {
  assert_true(sweep(150, [](uint64_t seed) {
    Rng rng(seed);
    Scene scene = draw(rng);
    scene.def.accuracy = accuracy;
    const Grid grid(scene.def);
    const size_t count = scene.particles.count();
    for (int k = 0; k < 300; k++) {
      const size_t i = rng.below(count), j = rng.below(count);
      double moved[3] = {0, 0, 0};
      std::copy_n(scene.particles.center(j), scene.def.dimension, moved);
      moved[0] += rng.chance(0.3) ? rng.uniform(-1, 1) * largest_reach(scene.def, scene.particles) : 0;
      const oracle::Sphere a{scene.particles.center(i), scene.particles.radii[i] * (rng.chance(0.2) ? 2.5 : 1)};
      const oracle::Sphere b{moved, scene.particles.radii[j]};
      const bool expected = oracle::meets(scene.def, a, b, accuracy == HG_EXACT ? exact_interact : double_interact);
      require(grid.overlap(a.center, a.radius, b.center, b.radius) == expected, scene.name + ": another verdict");
      require(grid.overlap(b.center, b.radius, a.center, a.radius) == expected, scene.name + ": turned round");
    }
  }));
}

// As hg_query_sphere finds it.
void as_a_query(void **) {
  assert_true(sweep(150, [](uint64_t seed) {
    Rng rng(seed);
    const Scene scene = draw(rng);
    const Grid grid = make_grid(scene.def, scene.particles);
    for (int k = 0; k < 10; k++) {
      const double *center = scene.particles.center(rng.below(scene.particles.count()));
      const double radius = rng.uniform() * largest_reach(scene.def, scene.particles);
      std::vector<int32_t> expected;
      for (size_t row = 0; row < scene.particles.count(); row++) {
        if (!grid.overlap(center, radius, scene.particles.center(row), scene.particles.radii[row])) continue;
        expected.push_back(scene.def.index_base + static_cast<int32_t>(row));
      }
      const hgrid::View<int32_t> ids = grid.query_sphere(center, radius);
      require_same(scene.name.c_str(), std::vector<int32_t>(ids.begin(), ids.end()), expected);
    }
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_two_spheres<HG_EXACT>), cmocka_unit_test(any_two_spheres<HG_DOUBLE>),
                              cmocka_unit_test(as_a_query)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
