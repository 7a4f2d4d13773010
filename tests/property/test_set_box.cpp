// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Lives of a grid whose box changes: barostats, shear, flips, boxes from elsewhere, particles that move, come and go,
// with and without a skin, against the oracle after each step. Boxes and particles that do not fit change nothing.
#include "tests/property/life.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace {

using namespace hgtest;

Life live(uint64_t seed, double skin_share) {
  Rng rng(seed);
  const int dimension = rng.integer(2, 3), axes = rng.integer(1, (1 << dimension) - 1);
  const auto sizes = static_cast<Sizes>(rng.below(kSizesCount));
  const size_t count = 1 + rng.below(100);
  const uint64_t kind = rng.below(4);
  Scene scene = kind == 0   ? periodic_scene(rng, dimension, axes, count, sizes)
                : kind == 1 ? many_images_scene(rng, dimension, axes, 1 + count / 3, sizes)
                            : tilted_scene(rng, dimension, draw_tilted_axes(rng, dimension), count, sizes);
  draw_levels(rng, scene);
  scene.def.accuracy = rng.chance(0.3) ? HG_DOUBLE : HG_EXACT;
  scene.def.pair_order = rng.integer(HG_ORDER_GRID, HG_ORDER_ID);
  scene.def.skin = skin_share * mean_radius(scene.particles);
  Life life(rng.next(), std::move(scene), 0.7, 0);
  life.run(15);
  return life;
}

void lives_without_a_skin(void **) {
  assert_true(sweep(300, [](uint64_t seed) { live(seed, 0); }));
}

int64_t filtered = 0, searched = 0;

void lives_with_a_skin(void **) {
  assert_true(sweep(500, [](uint64_t seed) {
    constexpr double kShares[] = {1e-6, 0.02, 0.3, 1, 10, 1e6};
    const Life life = live(1000 + seed, kShares[seed % 6]);
    filtered += life.stats().filter_count;
    searched += life.stats().search_count;
  }));
  // Both ways of answering must have been tried.
  assert_true(filtered > 500);
  assert_true(searched > 500);
}

// A crowd in a tilted box, with contacts enough that a wrong image shows.
Scene crowd(Rng &rng, double skin) {
  Scene scene;
  hg_grid_def &def = scene.def;
  def.thread_count = 1;
  def.skin = skin;
  for (int k = 0; k < 3; k++) {
    def.periodic[k] = 1;
    def.box_min[k] = -4;
    def.box_max[k] = 4;
  }
  for (int i = 0; i < 300; i++) {
    const double x[3] = {rng.uniform(-4, 4), rng.uniform(-4, 4), rng.uniform(-4, 4)};
    scene.particles.add(x, rng.uniform(0.1, 0.6));
  }
  return scene;
}

// Lees-Edwards: the tilt grows from step to step, and by a whole box back where it exceeds half of one; particles move
// along. The same lattice before and after a flip has the same pairs.
void sheared_through_flips(void **) {
  assert_true(sweep(6, [](uint64_t seed) {
    Rng rng(seed);
    Scene scene = crowd(rng, seed % 2 == 0 ? 0 : 0.3);
    hg_grid_def &def = scene.def;
    Grid grid = make_grid(def, scene.particles);
    const double strain = seed < 4 ? 0.01 : 0.13;
    for (int step = 0; step < 60; step++) {
      def.tilt[0] += strain * 8;
      if (def.tilt[0] > 4) {
        set_box(grid, def);
        const Pairs before = sorted_pairs_of(grid);
        def.tilt[0] -= 8;
        set_box(grid, def);
        require_same("after a flip", sorted_pairs_of(grid), before);
      }
      set_box(grid, def);
      if (seed % 3 != 0) {
        for (size_t i = 0; i < scene.particles.count(); i++) {
          scene.particles.centers[3 * i] += strain * scene.particles.centers[3 * i + 1];
        }
        grid.move(scene.particles.count(), scene.particles.centers.data());
      }
      require_same("sheared", sorted_pairs_of(grid), all_pairs(def, scene.particles, exact_interact));
    }
  }));
}

// Small changes of the box leave the candidates of a skin valid; large ones do not.
void candidates_stay_in_use(void **) {
  assert_true(holds(3, [](uint64_t seed) {
    Rng rng(seed);
    Scene scene = crowd(rng, 0.4);
    hg_grid_def &def = scene.def;
    const Grid grid = make_grid(def, scene.particles);
    const auto require_step = [&](const char *what, bool searches) {
      set_box(grid, def);
      const int64_t before = grid.get_stats().search_count;
      require_same(what, sorted_pairs_of(grid), all_pairs(def, scene.particles, exact_interact));
      require((grid.get_stats().search_count > before) == searches,
              std::string(what) + (searches ? " does not search anew" : " searches anew"));
    };
    require_step("the first", true);
    require_step("the same box", false);
    def.tilt[0] = 0.02;
    require_step("a little shear", false);
    def.tilt[1] = -0.01;
    def.tilt[2] = 0.01;
    require_step("a little more shear", false);
    def.box_max[1] = 4.02;
    require_step("a little stretch", false);
    for (double &x : def.box_max) x = 4.01;
    require_step("a little breath", false);
    def.tilt[0] = 3;
    require_step("much shear", true);
    for (double &x : def.box_max) x = 3;
    require_step("much less", true);
  }));
}

// Where only one refusal in several calls changed something, the last call would show it.
void refused_boxes_change_nothing(void **) {
  assert_true(sweep(2, [](uint64_t seed) {
    Rng rng(seed);
    Scene scene = crowd(rng, seed == 0 ? 0 : 0.2);
    hg_grid_def &def = scene.def;
    def.periodic[2] = 0;
    def.tilt[0] = 1;
    const Grid grid = make_grid(def, scene.particles);
    const Pairs expected = all_pairs(def, scene.particles, exact_interact);
    require_same("at first", sorted_pairs_of(grid), expected);
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    const double low[3] = {-4, -4, -4}, high[3] = {4, 4, 4};
    const auto require_refused = [&](const char *what, hg_status expected_status, const double *box_min,
                                     const double *box_max, const double *tilt) {
      require(hg_set_box(grid.get(), box_min, box_max, tilt) == expected_status, std::string(what) + " is not refused");
      require(hg_last_error()[0] != '\0', std::string(what) + ": no text");
      require_same(what, sorted_pairs_of(grid), expected);
    };
    for (const double bad : {nan, infinity, -infinity, -4.0, -5.0}) {
      const double bad_high[3] = {4, bad, 4};
      require_refused("a bad box_max", HG_ERR_ARGUMENT, low, bad_high, nullptr);
    }
    for (const double bad : {nan, infinity, -infinity, 4.0, 5.0}) {
      const double bad_low[3] = {bad, -4, -4};
      require_refused("a bad box_min", HG_ERR_ARGUMENT, bad_low, high, nullptr);
    }
    for (const double bad : {nan, infinity, -infinity}) {
      const double bad_tilt[3] = {bad, 0, 0};
      require_refused("a bad tilt", HG_ERR_ARGUMENT, low, high, bad_tilt);
    }
    for (const double bad : {0x1p20 * 8.5, -0x1p20 * 8.5}) {
      const double bad_tilt[3] = {bad, 0, 0};
      require_refused("too large a tilt", HG_ERR_LIMIT, low, high, bad_tilt);
    }
    const double open_tilt[3] = {0, 0, 1}, short_high[3] = {-3, 4, 4}, tiny_high[3] = {4, -3.999, 4};
    require_refused("a tilt of an open axis", HG_ERR_ARGUMENT, low, high, open_tilt);
    require_refused("a short box", HG_ERR_ARGUMENT, low, short_high, nullptr);
    require_refused("a tiny box", HG_ERR_ARGUMENT, low, tiny_high, nullptr);
    const double far_low[3] = {1e12, -4, -4}, far_high[3] = {1e12 + 8, 4, 4};
    require_refused("a box far away", HG_ERR_LIMIT, far_low, far_high, nullptr);
    require_refused("no box_min", HG_ERR_NULL, nullptr, high, nullptr);
    require_refused("no box_max", HG_ERR_NULL, low, nullptr, nullptr);
    const double open_nan[3] = {-4, -4, nan};
    def.tilt[0] = 0;
    require(hg_set_box(grid.get(), open_nan, high, nullptr) == HG_OK, "numbers of an open axis are read");
    require_same("at last", sorted_pairs_of(grid), all_pairs(def, scene.particles, exact_interact));
  }));
}

// The box that fits is found by what is there now: one giant, two of them, none after they have gone.
void giants_in_short_boxes(void **) {
  assert_true(holds(0, [](uint64_t) {
    for (const int32_t interaction : {HG_CONTACT, HG_MAX_RANGE}) {
      hg_grid_def def = hg_default_grid_def();
      def.interaction = interaction;
      for (int k = 0; k < 3; k++) {
        def.periodic[k] = 1;
        def.box_max[k] = 4;
      }
      def.tilt[0] = 2;
      Grid grid(def);
      // One giant and small ones: 2 (r1 + r2) = 4 just fits; a second giant does not.
      const double centers[9] = {0, 0, 0, 2.5, 1, 1, 1, 3, 2}, one[3] = {1.75, 0.25, 0.25}, two[3] = {1.75, 0.5, 0.25};
      const double range[3] = {2, 2, 1}, longer[3] = {1, std::nextafter(2.0, 3), 1};
      const bool contact = interaction == HG_CONTACT;
      const auto insert = [&](size_t count, const double *radii) {
        return status_of([&] { grid.insert(count, centers, radii); });
      };
      const double huge = 100;
      require(insert(1, &huge) == HG_OK, "a lone particle is refused");
      require(pairs_of(grid).empty(), "a lone particle meets itself");
      require(insert(1, contact ? &one[1] : &longer[0]) == HG_ERR_ARGUMENT, "a particle next to a huge one is taken");
      grid.clear();
      require(insert(3, contact ? two : longer) == HG_ERR_ARGUMENT, "two giants are taken");
      const std::string text = hg_last_error();
      require(text.find(contact ? "particles 0 and 1" : "particles 1 and 0") != std::string::npos,
              "not named: " + text);
      require(insert(3, contact ? one : range) == HG_OK, std::string("one giant is refused: ") + hg_last_error());
      Particles particles;
      for (size_t i = 0; i < 3; i++) particles.add(centers + 3 * i, contact ? one[i] : range[i]);
      require_same("one giant", sorted_pairs_of(grid), all_pairs(def, particles, exact_interact));
      require(status_of([&] { grid.move(3, centers, contact ? two : longer); }) == HG_ERR_ARGUMENT, "growth is taken");
      require_same("after a refusal", sorted_pairs_of(grid), all_pairs(def, particles, exact_interact));
      const double low[3] = {0, 0, 0}, high[3] = {4, std::nextafter(4.0, 0), 3.5};
      require(hg_set_box(grid.get(), low, high, def.tilt) == HG_ERR_ARGUMENT, "a short box is taken");
      const int32_t gone[2] = {0, 1};
      grid.remove(contact ? 1 : 2, gone);
      require(hg_set_box(grid.get(), low, high, def.tilt) == HG_OK, "the box is refused after the giant has gone");
    }
  }));
}

// A grid of open axes has no box to change; an empty one takes any.
void boxes_without_particles(void **) {
  assert_true(holds(0, [](uint64_t seed) {
    Rng rng(seed);
    Scene scene = crowd(rng, 0);
    const Grid grid(scene.def);
    const double low[3] = {0, 0, 0}, high[3] = {0.1, 0.1, 0.1}, tilt[3] = {0.3, -0.5, 0.05};
    require(hg_set_box(grid.get(), low, high, tilt) == HG_OK, "an empty grid refuses a small box");
    require(pairs_of(grid).empty(), "pairs of nothing");
    require(hg_set_box(Grid().get(), low, high, nullptr) == HG_OK, "a grid of open axes looks at a box");
    require(hg_set_box(Grid().get(), low, high, tilt) == HG_ERR_ARGUMENT, "open axes are tilted");
    set_box(grid, scene.def);
    Grid filled = make_grid(scene.def, scene.particles);
    filled.clear();
    require(hg_set_box(filled.get(), low, high, tilt) == HG_OK, "a cleared grid refuses a small box");
    set_box(filled, scene.def);
    filled.insert(scene.particles.count(), scene.particles.centers.data(), scene.particles.radii.data());
    require_same("filled again", sorted_pairs_of(filled), all_pairs(scene.def, scene.particles, exact_interact));
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(lives_without_a_skin),         cmocka_unit_test(lives_with_a_skin),
                              cmocka_unit_test(sheared_through_flips),        cmocka_unit_test(candidates_stay_in_use),
                              cmocka_unit_test(refused_boxes_change_nothing), cmocka_unit_test(giants_in_short_boxes),
                              cmocka_unit_test(boxes_without_particles)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
