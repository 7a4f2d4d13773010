// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// All ways to ask one grid give the same answer: pairs in both orders, batches, neighbour lists, spheres; for any
// number of threads, and again the same bytes.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

using namespace hgtest;

Pairs visited(const Grid &grid) {
  Pairs pairs;
  grid.visit_pairs([&](hgrid::View<hg_pair> batch) { pairs.insert(pairs.end(), batch.begin(), batch.end()); });
  return pairs;
}

void check_orders(uint64_t seed) {
  Rng rng(seed);
  Scene scene = any_scene(rng, rng.below(200));
  const Pairs expected = all_pairs(scene.def, scene.particles, exact_interact);
  Pairs in_grid_order;
  for (int32_t threads = 1; threads <= 4; threads++) {
    scene.def.thread_count = threads;
    scene.def.pair_order = HG_ORDER_ID;
    const Grid by_id = make_grid(scene.def, scene.particles);
    require_same("id order", pairs_of(by_id), expected);
    require_same("visit in id order", visited(by_id), expected);
    scene.def.pair_order = HG_ORDER_GRID;
    const Grid by_cell = make_grid(scene.def, scene.particles);
    require_same("visit in grid order", sorted(visited(by_cell)), expected);
    const Pairs pairs = pairs_of(by_cell);
    require_same("grid order", sorted(pairs), expected);
    if (threads == 1) in_grid_order = pairs;
    require_same("grid order with more threads", pairs, in_grid_order);
    require_same("grid order, asked again", pairs_of(by_cell), in_grid_order);
  }
}
void orders_threads_and_repeats(void **) { assert_true(sweep(150, check_orders)); }

// Enough particles that threads have work to share.
void check_large(uint64_t seed) {
  Rng rng(seed);
  const Sizes sizes = static_cast<Sizes>(seed % kSizesCount);
  constexpr Places kOpen[] = {Places::kUniform, Places::kFilaments, Places::kScales};
  Scene scene = seed % 3 == 0   ? periodic_scene(rng, 3, 5, 5000, sizes)
                : seed % 3 == 1 ? tilted_scene(rng, 3, 7, 5000, sizes)
                                : open_scene(rng, 3, 5000, sizes, kOpen[seed / 3 % 3]);
  const Pairs expected = all_pairs(scene.def, scene.particles, exact_interact);
  Pairs with_one_thread;
  for (int32_t threads : {1, 2, 3, 8}) {
    scene.def.thread_count = threads;
    const Grid grid = make_grid(scene.def, scene.particles);
    const Pairs pairs = pairs_of(grid);
    require_same(scene.name.c_str(), sorted(pairs), expected);
    if (threads == 1) with_one_thread = pairs;
    require_same("grid order with more threads", pairs, with_one_thread);
    require_same("visit", visited(grid), with_one_thread);
  }
}
void large_sets(void **) { assert_true(sweep(9, check_large)); }

// Rows count from 0 whatever the first id is; what they hold are ids.
void check_neighbors(uint64_t seed) {
  Rng rng(seed);
  const Scene scene = any_scene(rng, rng.below(250));
  const Grid grid = make_grid(scene.def, scene.particles);
  Pairs half, full;
  for (const hg_pair &pair : all_pairs(scene.def, scene.particles, exact_interact)) {
    half.push_back({pair.a - scene.def.index_base, pair.b});
    full.insert(full.end(), {half.back(), {pair.b - scene.def.index_base, pair.a}});
  }
  require_same("half list", pairs_of_rows(grid, HG_HALF), half);
  require_same("full list", pairs_of_rows(grid, HG_FULL), sorted(full));
}
void neighbour_lists(void **) { assert_true(sweep(250, check_neighbors)); }

// Spheres at and between the particles, from points to larger than everything.
void check_spheres(uint64_t seed) {
  Rng rng(seed);
  Scene scene = any_scene(rng, 1 + rng.below(200));
  scene.def.accuracy = rng.chance(0.7) ? HG_EXACT : HG_DOUBLE;
  oracle::Rule *rule = scene.def.accuracy == HG_EXACT ? exact_interact : double_interact;
  const Grid grid = make_grid(scene.def, scene.particles);
  const size_t count = scene.particles.count();
  Particles spheres;
  spheres.dimension = scene.particles.dimension;
  std::vector<std::vector<int32_t>> expected;
  for (int k = 0; k < 12; k++) {
    double center[3];
    const double *a = scene.particles.center(rng.below(count));
    const double *b = scene.particles.center(rng.below(count));
    const double t = rng.chance(0.5) ? 0 : rng.uniform();
    for (int axis = 0; axis < scene.particles.dimension; axis++) center[axis] = a[axis] + t * (b[axis] - a[axis]);
    const double radius =
        rng.chance(0.3) ? 0 : scene.particles.radii[rng.below(count)] * std::pow(10, rng.uniform(-2, 3));
    const hgrid::View<int32_t> ids = grid.query_sphere(center, radius);
    spheres.add(center, radius);
    expected.push_back(all_in_sphere(scene.def, scene.particles, {center, radius}, rule));
    require_same(scene.name.c_str(), list_of(ids), expected.back());
  }
  require_rows(scene.name, grid.query_spheres(spheres.count(), spheres.centers.data(), spheres.radii.data()), expected);
}
void spheres(void **) { assert_true(sweep(400, check_spheres)); }

// More than one thread takes at once, in space and far outside it: the same as one by one, for any number of threads.
void check_many_spheres(uint64_t seed) {
  Rng rng(seed);
  Scene scene = any_scene(rng, 1000);
  Particles spheres;
  spheres.dimension = scene.particles.dimension;
  for (size_t k = 0; k < 1000; k++) {
    const double *a = scene.particles.center(rng.below(1000)), *b = scene.particles.center(rng.below(1000));
    const double t = rng.chance(0.9) ? rng.uniform() : rng.uniform(-3, 3);
    double center[3];
    for (int axis = 0; axis < scene.particles.dimension; axis++) center[axis] = a[axis] + t * (b[axis] - a[axis]);
    spheres.add(center, scene.particles.radii[rng.below(1000)] * rng.uniform(0, 2));
  }
  std::vector<std::vector<int32_t>> expected;
  for (const int32_t threads : {1, 2, 5}) {
    scene.def.thread_count = threads;
    const Grid grid = make_grid(scene.def, scene.particles);
    for (size_t k = 0; threads == 1 && k < spheres.count(); k++) {
      expected.push_back(list_of(grid.query_sphere(spheres.center(k), spheres.radii[k])));
    }
    require_rows(scene.name, grid.query_spheres(1000, spheres.centers.data(), spheres.radii.data()), expected);
  }
}
void many_spheres(void **) { assert_true(sweep(40, check_many_spheres)); }

// The order of the input and of the axes is of no matter to the set of pairs, nor is a power of two in all lengths.
void check_symmetry(uint64_t seed) {
  Rng rng(seed);
  const Scene scene = open_scene(rng, 3, rng.below(250), static_cast<Sizes>(rng.below(kSizesCount)), Places::kUniform);
  const size_t count = scene.particles.count();
  const Pairs expected = sorted_pairs_of(make_grid(scene.def, scene.particles));
  std::vector<size_t> source(count);
  std::iota(source.begin(), source.end(), 0);
  for (size_t i = count; i > 1; i--) std::swap(source[i - 1], source[rng.below(i)]);
  const double scale = std::ldexp(1, rng.integer(-200, 200));
  hg_grid_def def = scene.def;
  def.margin *= scale;
  Particles shuffled;
  for (size_t i : source) {
    const double *x = scene.particles.center(i);
    const double turned[3] = {x[1] * scale, -x[2] * scale, x[0] * scale};
    shuffled.add(turned, scene.particles.radii[i] * scale);
  }
  Pairs back = pairs_of(make_grid(def, shuffled));
  for (hg_pair &pair : back) {
    const int32_t a = static_cast<int32_t>(source[static_cast<size_t>(pair.a - def.index_base)]);
    const int32_t b = static_cast<int32_t>(source[static_cast<size_t>(pair.b - def.index_base)]);
    pair = {std::min(a, b) + def.index_base, std::max(a, b) + def.index_base};
  }
  require_same("shuffled, turned and scaled", sorted(back), expected);
}
void symmetries(void **) { assert_true(sweep(200, check_symmetry)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(orders_threads_and_repeats),
                              cmocka_unit_test(large_sets),
                              cmocka_unit_test(neighbour_lists),
                              cmocka_unit_test(spheres),
                              cmocka_unit_test(many_spheres),
                              cmocka_unit_test(symmetries)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
