// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Lives of a grid whose box changes: barostats, shear, flips, boxes from elsewhere, particles that move, come and go,
// with and without a skin, against the oracle after each step. Boxes and particles that do not fit change nothing.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace {

using namespace hgtest;

void set_box(const Grid &grid, const hg_grid_def &def) {
  hgrid::check(hg_set_box(grid.get(), def.box_min, def.box_max, def.tilt));
}

// Whether a particle is so many cells away, or is taken there on the way, that the grid may refuse it.
bool has_far_particles(const hg_grid_def &def, const Particles &particles) {
  for (size_t i = 0; i < particles.count(); i++) {
    const double *x = particles.center(i);
    double cells[3] = {0, 0, 0};
    for (int k = def.dimension - 1; k >= 0; k--) {
      if (def.periodic[k] == 0) continue;
      const double tilted = k == 0   ? std::fabs(cells[1] * def.tilt[0]) + std::fabs(cells[2] * def.tilt[1])
                            : k == 1 ? std::fabs(cells[2] * def.tilt[2])
                                     : 0;
      cells[k] = (std::fabs(x[k] - def.box_min[k]) + tilted) / (def.box_max[k] - def.box_min[k]) + 1;
      if (cells[k] > 0x1p18) return true;
    }
  }
  return false;
}

// What a deformation does with the box.
enum class Change { kBreathe, kStretch, kShear, kRamp, kFlip, kShift, kOther };
constexpr int kChangeCount = static_cast<int>(Change::kOther) + 1;

class Life {
 public:
  Life(uint64_t seed, double skin_share) : rng_(seed), scene_(draw(rng_)) {
    double mean = 0;
    for (const double r : scene_.particles.radii) mean += r / static_cast<double>(scene_.particles.count());
    scene_.def.skin = skin_share * mean;
    small_ = skin_share > 0 ? std::min(scene_.def.skin, mean) : 0.1 * mean;
    live_ = scene_.particles;
    for (size_t i = 0; i < live_.count(); i++) ids_.push_back(scene_.def.index_base + static_cast<int32_t>(i));
    next_id_ = scene_.def.index_base + static_cast<int32_t>(live_.count());
    grid_ = make_grid(scene_.def, live_);
  }

  void run(int steps) {
    compare();
    for (int step = 0; step < steps; step++) {
      const int action = rng_.integer(0, 9);
      if (action < 5) change_box();
      if (action >= 3 && action < 8) move();
      if (action == 8) insert();
      if (action == 9) remove();
      if (rng_.chance(0.8)) compare();
    }
    compare();
  }

  hg_grid_stats stats() const { return grid_.get_stats(); }

 private:
  static Scene draw(Rng &rng) {
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
    return scene;
  }

  double length(int axis) const { return scene_.def.box_max[axis] - scene_.def.box_min[axis]; }

  void change_box() {
    hg_grid_def def = scene_.def;
    const auto change = static_cast<Change>(rng_.below(kChangeCount));
    // So small that places at the far face move by a part of the skin, or not.
    const double share = rng_.chance(0.8) ? 0.2 * small_ / std::max({length(0), length(1), length(2)}) : 0.1;
    for (int k = 0; k < def.dimension; k++) {
      if (def.periodic[k] == 0) continue;
      if (change == Change::kBreathe) def.box_max[k] += share * length(k);
      if (change == Change::kStretch) def.box_max[k] += rng_.uniform(-share, share) * length(k);
      if (change == Change::kShift) {
        const double shift = rng_.uniform(-1, 1) * length(k);
        def.box_min[k] += shift;
        def.box_max[k] += shift;
      }
      const double least = length(k) > largest_reach(def, live_) ? -0.3 : 0;  // images grow with its cube
      if (change == Change::kOther) def.box_max[k] += rng_.uniform(least, 0.5) * length(k);
    }
    constexpr int kAxes[3][2] = {{0, 1}, {0, 2}, {1, 2}};
    for (int k = 0; k < (def.dimension == 2 ? 1 : 3); k++) {
      if (def.periodic[kAxes[k][0]] + def.periodic[kAxes[k][1]] != 2) continue;
      const double along = length(kAxes[k][0]);
      if (change == Change::kShear) def.tilt[k] += rng_.uniform(-share, share) * along;
      if (change == Change::kRamp) def.tilt[k] += share * along;
      if (change == Change::kFlip) def.tilt[k] -= std::nearbyint(def.tilt[k] / along) * along;
      if (change == Change::kOther) def.tilt[k] = rng_.uniform(-1, 1) * along;
    }
    if (has_far_particles(def, live_)) return;
    const bool fits = def.images == HG_ALL_IMAGES || !can_meet_twice(def, live_);
    const hg_status status = status_of([&] { set_box(grid_, def); });
    require(status == (fits ? HG_OK : HG_ERR_ARGUMENT),
            scene_.name + ": the box is taken with " + std::to_string(status) + ", " + hg_last_error());
    if (fits) scene_.def = def;
  }

  void move() {
    const bool far = rng_.chance(0.1), radii = rng_.chance(0.2);
    const auto dimension = static_cast<size_t>(live_.dimension);
    const double step = 0.1 * small_;
    for (size_t i = 0; i < live_.count(); i++) {
      double *x = &live_.centers[i * dimension];
      for (size_t k = 0; k < dimension; k++) x[k] += rng_.uniform(-step, step);
      if (far && rng_.chance(0.2)) {
        const double n[3] = {1.0 * rng_.integer(-2, 2), 1.0 * rng_.integer(-2, 2), 1.0 * rng_.integer(-2, 2)};
        move_by_cells(scene_.def, n, x);
      }
      if (radii) live_.radii[i] *= rng_.uniform(0.9, 1);
    }
    grid_.move(live_.count(), live_.centers.data(), radii ? live_.radii.data() : nullptr);
  }

  // What was there at first fits no box that has shrunk since: it may be refused.
  void insert() {
    const Particles &pool = scene_.particles;
    Particles grown = live_, batch;
    batch.dimension = live_.dimension;
    for (int k = rng_.integer(1, 10); k > 0; k--) {
      const size_t row = rng_.below(pool.count());
      batch.add(pool.center(row), pool.radii[row]);
      grown.add(pool.center(row), pool.radii[row]);
    }
    if (has_far_particles(scene_.def, batch)) return;
    const bool fits = scene_.def.images == HG_ALL_IMAGES || !can_meet_twice(scene_.def, grown);
    const hg_status status = status_of([&] { grid_.insert(batch.count(), batch.centers.data(), batch.radii.data()); });
    require(status == (fits ? HG_OK : HG_ERR_ARGUMENT),
            scene_.name + ": particles are taken with " + std::to_string(status) + ", " + hg_last_error());
    if (!fits) return;
    live_ = grown;
    while (ids_.size() < live_.count()) ids_.push_back(next_id_++);
  }

  void remove() {
    if (live_.count() < 2) return;
    const size_t row = rng_.below(live_.count());
    grid_.remove(1, &ids_[row]);
    const auto dimension = static_cast<ptrdiff_t>(live_.dimension), at = static_cast<ptrdiff_t>(row);
    ids_.erase(ids_.begin() + at);
    live_.radii.erase(live_.radii.begin() + at);
    live_.centers.erase(live_.centers.begin() + at * dimension, live_.centers.begin() + (at + 1) * dimension);
  }

  void compare() {
    const auto rule = scene_.def.accuracy == HG_DOUBLE ? double_interact : exact_interact;
    const Pairs expected = all_pairs(scene_.def, live_, ids_, rule);
    const Pairs found = pairs_of(grid_);
    require_same(scene_.name.c_str(), scene_.def.pair_order == HG_ORDER_ID ? found : sorted(found), expected);
    if (rng_.chance(0.3)) {
      Pairs visited;
      grid_.visit_pairs([&](hgrid::View<hg_pair> batch) { visited.insert(visited.end(), batch.begin(), batch.end()); });
      require_same((scene_.name + ", visited").c_str(), sorted(visited), expected);
    }
    if (rng_.chance(0.3)) compare_sphere(rule);
  }

  void compare_sphere(oracle::Rule *rule) {
    const double *center = live_.center(rng_.below(live_.count()));
    const double radius = live_.radii[rng_.below(live_.count())];
    const hgrid::View<int32_t> rows = grid_.query_sphere(center, radius);
    std::vector<int32_t> expected;
    for (const int32_t id : all_in_sphere(scene_.def, live_, {center, radius}, rule)) {
      expected.push_back(ids_[static_cast<size_t>(id - scene_.def.index_base)]);
    }
    require_same((scene_.name + ", sphere").c_str(), std::vector<int32_t>(rows.begin(), rows.end()), expected);
  }

  Rng rng_;
  Scene scene_;
  Particles live_;
  std::vector<int32_t> ids_;
  int32_t next_id_ = 0;
  double small_ = 0;
  Grid grid_;
};

void lives_without_a_skin(void **) {
  assert_true(sweep(300, [](uint64_t seed) { Life(seed, 0).run(15); }));
}

int64_t filtered = 0, searched = 0;

void lives_with_a_skin(void **) {
  assert_true(sweep(500, [](uint64_t seed) {
    constexpr double kShares[] = {1e-6, 0.02, 0.3, 1, 10, 1e6};
    Life life(1000 + seed, kShares[seed % 6]);
    life.run(15);
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
