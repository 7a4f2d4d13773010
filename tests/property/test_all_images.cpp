// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// HG_ALL_IMAGES: each image in reach is a pair, in boxes shorter than a particle, tilted or not; all ways to ask agree;
// lattices of one particle against known numbers of neighbours.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace {

using namespace hgtest;

Scene draw(Rng &rng) {
  const int dimension = rng.integer(2, 3), axes = rng.integer(1, (1 << dimension) - 1);
  const size_t count = rng.chance(0.3) ? 1 + rng.below(3) : rng.below(60);
  Scene scene = many_images_scene(rng, dimension, axes, count, static_cast<Sizes>(rng.below(kSizesCount)));
  draw_levels(rng, scene);
  return scene;
}

template <int32_t accuracy>
void any_box(void **) {
  assert_true(sweep(accuracy == HG_EXACT ? 500 : 250, [](uint64_t seed) {
    Rng rng(seed + 1000 * accuracy);
    Scene scene = draw(rng);
    scene.def.accuracy = accuracy;
    const Pairs found = sorted_pairs_of(make_grid(scene.def, scene.particles));
    const Pairs exact = all_pairs(scene.def, scene.particles, exact_interact);
    if (accuracy == HG_EXACT) {
      require_same(scene.name.c_str(), found, exact);
    } else if (accuracy == HG_DOUBLE) {
      require_same(scene.name.c_str(), found, all_pairs(scene.def, scene.particles, double_interact));
    } else {
      require_superset(scene.name, scene.def, scene.particles, found, exact);
    }
  }));
}

// Orders, batches, rows and spheres; a particle's own images stand once in its half row and twice in its full row.
void check_queries(uint64_t seed) {
  Rng rng(seed);
  Scene scene = draw(rng);
  const Pairs expected = all_pairs(scene.def, scene.particles, exact_interact);
  Pairs half, full;
  for (const hg_pair &pair : expected) {
    half.push_back({pair.a - scene.def.index_base, pair.b});
    full.insert(full.end(), {half.back(), {pair.b - scene.def.index_base, pair.a}});
  }
  Pairs in_grid_order;
  for (const int32_t threads : {1, 3}) {
    scene.def.thread_count = threads;
    scene.def.pair_order = HG_ORDER_ID;
    require_same("id order", pairs_of(make_grid(scene.def, scene.particles)), expected);
    scene.def.pair_order = HG_ORDER_GRID;
    const Grid grid = make_grid(scene.def, scene.particles);
    Pairs visited;
    grid.visit_pairs([&](hgrid::View<hg_pair> batch) { visited.insert(visited.end(), batch.begin(), batch.end()); });
    require_same("visit", sorted(visited), expected);
    require_same("half rows", pairs_of_rows(grid, HG_HALF), half);
    require_same("full rows", pairs_of_rows(grid, HG_FULL), sorted(full));
    const Pairs found = pairs_of(grid);
    if (threads == 1) in_grid_order = found;
    require_same("more threads", found, in_grid_order);
    for (int k = 0; k < 5 && scene.particles.count() > 0; k++) {
      double center[3] = {0, 0, 0};
      std::copy_n(scene.particles.center(rng.below(scene.particles.count())), scene.def.dimension, center);
      center[0] += rng.uniform(-1, 1) * largest_reach(scene.def, scene.particles);
      const double radius = rng.uniform(0, 1) * largest_reach(scene.def, scene.particles);
      const hgrid::View<int32_t> ids = grid.query_sphere(center, radius);
      require_same("sphere", std::vector<int32_t>(ids.begin(), ids.end()),
                   all_in_sphere(scene.def, scene.particles, {center, radius}, exact_interact));
    }
  }
}
void all_queries_agree(void **) { assert_true(sweep(200, check_queries)); }

// Where no two particles can meet twice and none itself, all images are the nearest ones.
void check_long_box(uint64_t seed) {
  Rng rng(seed);
  const int dimension = rng.integer(2, 3);
  const auto sizes = static_cast<Sizes>(rng.below(kSizesCount));
  Scene scene = rng.chance(0.5) ? tilted_scene(rng, dimension, draw_tilted_axes(rng, dimension), 150, sizes)
                                : periodic_scene(rng, dimension, rng.integer(1, (1 << dimension) - 1), 150, sizes);
  const Pairs nearest = sorted_pairs_of(make_grid(scene.def, scene.particles));
  scene.def.images = HG_ALL_IMAGES;
  require_same(scene.name.c_str(), sorted_pairs_of(make_grid(scene.def, scene.particles)), nearest);
}
void long_boxes_as_with_the_nearest(void **) { assert_true(sweep(150, check_long_box)); }

// Half the points of a cubic or square lattice within a radius, the origin left out: Gauss's circle problem.
struct Ball {
  int dimension;
  double diameter;
  size_t touching, strict;
};
constexpr Ball kBalls[] = {{2, 1, 2, 0},   {2, 2, 6, 4}, {2, 3, 14, 12}, {2, 5, 40, 34}, {2, 10, 158, 152},
                           {3, 0.5, 0, 0}, {3, 1, 3, 0}, {3, 2, 16, 13}, {3, 3, 61, 46}};

// One particle, alone in the unit cell of the lattice, written with any tilt of whole lengths, and far from the origin.
void one_particle_alone(void **) {
  assert_true(sweep(60, [](uint64_t seed) {
    Rng rng(seed);
    const double unit = std::ldexp(1, rng.integer(-30, 30));
    for (const Ball &ball : kBalls) {
      hg_grid_def def = hg_default_grid_def();
      def.dimension = ball.dimension;
      def.images = HG_ALL_IMAGES;
      def.accuracy = rng.integer(HG_EXACT, HG_DOUBLE);
      def.interaction = rng.integer(HG_CONTACT, HG_MAX_RANGE);
      def.margin = rng.chance(0.5) ? 0 : 0.25 * unit;
      for (int k = 0; k < ball.dimension; k++) {
        def.periodic[k] = 1;
        def.box_min[k] = rng.integer(-100, 100) * unit;
        def.box_max[k] = def.box_min[k] + unit;
        if (k == 0 || ball.dimension == 3) def.tilt[k] = rng.integer(-20, 20) * unit;
      }
      Particles particles;
      particles.dimension = ball.dimension;
      const double center[3] = {rng.integer(-800, 800) * 0.125 * unit, 0, rng.integer(-800, 800) * 0.125 * unit};
      const double reach = ball.diameter * unit - def.margin;
      particles.add(center, def.interaction == HG_CONTACT ? 0.5 * reach : reach);
      for (def.touching = 0; def.touching < 2; def.touching++) {
        const size_t count = def.touching != 0 ? ball.touching : ball.strict;
        require_same("ball", pairs_of(make_grid(def, particles)), Pairs(count, hg_pair{0, 0}));
      }
    }
  }));
}

// A giant that covers its box several times meets each mote as often as lattice points lie in it.
void giant_over_dust(void **) {
  assert_true(sweep(20, [](uint64_t seed) {
    Rng rng(seed);
    hg_grid_def def = hg_default_grid_def();
    def.images = HG_ALL_IMAGES;
    for (int k = 0; k < 3; k++) {
      def.periodic[k] = 1;
      def.box_max[k] = 1;
      def.tilt[k] = rng.chance(0.5) ? rng.uniform(-2, 2) : 0;
    }
    Particles particles;
    const double origin[3] = {0, 0, 0};
    particles.add(origin, 3);
    for (int i = 0; i < 150; i++) {
      const double x[3] = {rng.uniform(-2, 2), rng.uniform(-2, 2), rng.uniform(-2, 2)};
      particles.add(x, 1e-5 * rng.uniform());
    }
    require_exact("giant over dust", def, particles);
  }));
}

// More images than can be looked at are refused; the grid stays as it was.
void too_many_images(void **) {
  assert_true(holds(0, [](uint64_t) {
    hg_grid_def def = hg_default_grid_def();
    def.images = HG_ALL_IMAGES;
    def.periodic[0] = def.periodic[1] = 1;
    def.box_max[0] = def.box_max[1] = 1;
    Grid grid(def);
    const double centers[6] = {0, 0, 0, 0.5, 0.5, 0}, fine[2] = {0.4, 0.4}, huge[2] = {1, 1e12};
    require(status_of([&] { grid.insert(2, centers, huge); }) == HG_ERR_LIMIT, "a reach of 1e12 cells is taken");
    grid.insert(2, centers, fine);
    const Pairs four(4, hg_pair{0, 1});
    require_same("after a refusal", pairs_of(grid), four);
    require(status_of([&] { grid.move(2, centers, huge); }) == HG_ERR_LIMIT, "a reach of 1e12 cells is taken");
    require_same("after another", pairs_of(grid), four);
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_box<HG_EXACT>),
                              cmocka_unit_test(any_box<HG_DOUBLE>),
                              cmocka_unit_test(any_box<HG_FLOAT>),
                              cmocka_unit_test(all_queries_agree),
                              cmocka_unit_test(long_boxes_as_with_the_nearest),
                              cmocka_unit_test(one_particle_alone),
                              cmocka_unit_test(giant_over_dust),
                              cmocka_unit_test(too_many_images)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
