// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// With a skin the pairs are those of a search without one, after every step of any motion: small and large steps,
// growing and shrinking radii, steps of just half the skin, faces of periodic boxes. Neighbours, visits and spheres
// agree with them.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <algorithm>
#include <cmath>

namespace {

using namespace hgtest;

enum class Motion { kDrift, kJitter, kLimit, kGrowth, kWrap, kJump };
constexpr int kMotionCount = static_cast<int>(Motion::kJump) + 1;

// One scene that moves, and a grid with a skin that follows it.
class Run {
 public:
  Run(uint64_t seed, double skin_share) : rng_(seed), scene_(draw(rng_)) {
    double mean = 0;
    for (const double r : scene_.particles.radii) mean += r / static_cast<double>(scene_.particles.count());
    scene_.def.skin = skin_share * mean;
    half_ = 0.5 * std::min(scene_.def.skin, mean);
    largest_ = *std::max_element(scene_.particles.radii.begin(), scene_.particles.radii.end());
    grid_ = make_grid(scene_.def, scene_.particles);
  }

  void steps(int count) {
    compare();
    for (int step = 0; step < count; step++) {
      move(static_cast<Motion>(rng_.below(kMotionCount)));
      compare();
    }
  }

  hg_grid_stats stats() const { return grid_.get_stats(); }

 private:
  static Scene draw(Rng &rng) {
    Scene scene = any_scene(rng, 1 + rng.below(150));
    scene.def.accuracy = rng.chance(0.3) ? HG_DOUBLE : HG_EXACT;
    scene.def.pair_order = rng.integer(HG_ORDER_GRID, HG_ORDER_ID);
    return scene;
  }

  double *center(size_t i) { return &scene_.particles.centers[i * dimension()]; }
  size_t dimension() const { return static_cast<size_t>(scene_.particles.dimension); }

  void move(Motion motion) {
    Particles &p = scene_.particles;
    bool new_radii = rng_.chance(0.2);
    for (size_t i = 0; i < p.count(); i++) {
      switch (motion) {
        case Motion::kDrift:
          step(i, 0.3 * half_);
          break;
        case Motion::kJitter:
          step(i, 0.05 * half_);
          break;
        case Motion::kLimit:  // two that come nearer by the whole skin
          center(i)[0] += i % 2 == 0 ? half_ : -half_;
          break;
        case Motion::kGrowth:
          p.radii[i] = std::min(largest_, p.radii[i] * rng_.uniform(0.9, 1.0) + 0.2 * half_ * rng_.uniform(0, 1));
          new_radii = true;
          break;
        case Motion::kWrap:
          wrap(i);
          break;
        case Motion::kJump:
          if (rng_.chance(0.02)) step(i, 100 * half_ + largest_);
          break;
      }
    }
    grid_.move(p.count(), p.centers.data(), new_radii ? p.radii.data() : nullptr);
  }

  void step(size_t i, double most) {
    for (size_t k = 0; k < dimension(); k++) center(i)[k] += rng_.uniform(-most, most) / 2;
  }

  // The same place, some cells away, as far as doubles tell it.
  void wrap(size_t i) {
    const auto cells = [this] { return rng_.chance(0.3) ? rng_.integer(-2, 2) : 0.0; };
    const double n[3] = {cells(), cells(), cells()};
    move_by_cells(scene_.def, n, center(i));
  }

  void compare() {
    const bool by_double = scene_.def.accuracy == HG_DOUBLE;
    const Pairs expected = all_pairs(scene_.def, scene_.particles, by_double ? double_interact : exact_interact);
    if (rng_.chance(0.2)) grid_.build();
    if (rng_.chance(0.2)) compare_sphere(by_double);
    if (rng_.chance(0.3)) compare_visit(expected);
    if (rng_.chance(0.3)) compare_contacts(expected);
    require_same(scene_.name.c_str(), as_asked(pairs_of(grid_)), expected);
    if (rng_.chance(0.2)) compare_visit(expected);
    if (rng_.chance(0.2)) compare_contacts(expected);
    if (rng_.chance(0.3)) compare_neighbors(expected);
    if (rng_.chance(0.3)) compare_sphere(by_double);
  }

  void compare_visit(const Pairs &expected) {
    Pairs visited;
    grid_.visit_pairs([&](hgrid::View<hg_pair> batch) { visited.insert(visited.end(), batch.begin(), batch.end()); });
    require_same((scene_.name + ", visited").c_str(), as_asked(visited), expected);
  }

  // In the order of the list; what leads from a to b is what a search without a skin finds.
  void compare_contacts(const Pairs &expected) {
    const auto row = [this](int32_t id) { return static_cast<size_t>(id - scene_.def.index_base); };
    Pairs visited;
    std::vector<double> vectors;
    grid_.visit_contacts([&](const hg_contact_batch &batch) {
      for (size_t k = 0; k < batch.count; k++) {
        visited.push_back({batch.a[k], batch.b[k]});
        const double r = scene_.particles.radii[row(batch.a[k])], s = scene_.particles.radii[row(batch.b[k])];
        const double base = scene_.def.interaction == HG_MAX_RANGE ? std::fmax(r, s) : r + s;
        require(batch.reach[k] == base + scene_.def.margin, scene_.name + ": another reach");
        const double *components[3] = {batch.dx, batch.dy, batch.dz};
        for (size_t axis = 0; axis < dimension(); axis++) vectors.push_back(components[axis][k]);
      }
    });
    require_same((scene_.name + ", contacts").c_str(), as_asked(visited), expected);
    require_same((scene_.name + ", contacts as listed").c_str(), visited, pairs_of(grid_));
    const auto listed = grid_.query_pair_vectors().vectors;
    require(std::equal(vectors.begin(), vectors.end(), listed.begin(), listed.end()), scene_.name + ": other vectors");
    if (std::any_of(scene_.def.periodic, scene_.def.periodic + 3, [](int32_t is) { return is != 0; })) return;
    for (size_t k = 0; k < vectors.size(); k++) {
      const double *from = center(row(visited[k / dimension()].a)), *to = center(row(visited[k / dimension()].b));
      require(vectors[k] == to[k % dimension()] - from[k % dimension()], scene_.name + ": another vector");
    }
  }

  // HG_ORDER_ID promises the order, too.
  Pairs as_asked(const Pairs &pairs) const { return scene_.def.pair_order == HG_ORDER_ID ? pairs : sorted(pairs); }

  void compare_neighbors(const Pairs &expected) {
    const hgrid::Rows rows = grid_.query_neighbors(HG_HALF);
    Pairs pairs;
    for (size_t i = 0; i < scene_.particles.count(); i++) {
      for (const int32_t id : rows[i]) pairs.push_back({static_cast<int32_t>(i) + scene_.def.index_base, id});
    }
    require_same((scene_.name + ", neighbours").c_str(), pairs, expected);
  }

  void compare_sphere(bool by_double) {
    const size_t near = rng_.below(scene_.particles.count());
    double at[3];
    for (size_t k = 0; k < dimension(); k++) at[k] = center(near)[k] + rng_.uniform(-1, 1) * largest_;
    const Sphere sphere = {at, rng_.uniform(0, 2) * largest_};
    const hgrid::View<int32_t> ids = grid_.query_sphere(at, sphere.radius);
    require_same((scene_.name + ", sphere").c_str(), std::vector<int32_t>(ids.begin(), ids.end()),
                 all_in_sphere(scene_.def, scene_.particles, sphere, by_double ? double_interact : exact_interact));
  }

  Rng rng_;
  Scene scene_;
  double largest_ = 0;
  double half_ = 0;  // of the skin, or of a particle where the skin is wider
  Grid grid_;
};

int64_t filtered = 0, searched = 0;

void check_steps(uint64_t seed) {
  constexpr double kShares[] = {1e-6, 0.02, 0.3, 1, 10, 1e6, 1e300};
  Run run(seed, kShares[seed % 7]);
  run.steps(8);
  filtered += run.stats().filter_count;
  searched += run.stats().search_count;
}

void same_pairs_after_any_step(void **) {
  assert_true(sweep(700, check_steps));
  // Both ways of answering must have been tried.
  assert_true(filtered > 500);
  assert_true(searched > 500);
}

// A box a few units long, tilted or not, 2^30 from the origin, where steps are multiples of the coordinates' last
// digit; and pairs that come to touch exactly.
void check_coarse_places(uint64_t seed) {
  Rng rng(seed);
  hg_grid_def def = hg_default_grid_def();
  def.dimension = 2;
  def.tilt[0] = rng.chance(0.5) ? 0.25 * rng.integer(-50, 50) : 0;
  def.skin = 0.5;
  const double unit = 0x1p-22, corner = 0x1p30;
  for (int k = 0; k < 2; k++) {
    def.periodic[k] = 1;
    def.box_min[k] = corner;
    def.box_max[k] = corner + 8;
  }
  Particles particles;
  particles.dimension = 2;
  for (int i = 0; i < 30; i++) {
    const double x[2] = {corner + rng.integer(0, 32) * 0.25, corner + rng.integer(0, 32) * 0.25};
    particles.add(x, 0.25 * rng.integer(0, 4));
  }
  Grid grid = make_grid(def, particles);
  for (int step = 0; step < 6; step++) {
    require_same("coarse places", sorted_pairs_of(grid), all_pairs(def, particles, exact_interact));
    for (double &x : particles.centers) x += rng.integer(-1, 1) * (rng.chance(0.5) ? unit : 0.0625);
    grid.move(particles.count(), particles.centers.data());
  }
}
void coarse_places(void **) { assert_true(sweep(100, check_coarse_places)); }

// All lists of a run. After some steps particles are removed, so that ids have gaps from then on.
std::vector<Pairs> lists_of_steps(const Scene &start, double step, int threads, int32_t order) {
  hg_grid_def def = start.def;
  def.thread_count = threads;
  def.pair_order = order;
  Grid grid = make_grid(def, start.particles);
  Particles particles = start.particles;
  const auto width = static_cast<size_t>(particles.dimension);
  Rng rng(7);
  std::vector<Pairs> lists = {pairs_of(grid)};
  for (int k = 0; k < 8; k++) {
    for (double &x : particles.centers) x += rng.uniform(-step, step);
    grid.move(particles.count(), particles.centers.data());
    lists.push_back(pairs_of(grid));
    if (k != 3) continue;
    const int32_t gone[2] = {def.index_base, def.index_base + 4321};
    grid.remove(2, gone);
    particles.centers.erase(particles.centers.begin() + static_cast<ptrdiff_t>(4321 * width),
                            particles.centers.begin() + static_cast<ptrdiff_t>(4322 * width));
    particles.centers.erase(particles.centers.begin(), particles.centers.begin() + static_cast<ptrdiff_t>(width));
    particles.radii.resize(particles.count() - 2);
    lists.push_back(pairs_of(grid));
  }
  return lists;
}

// The lists, their order included, do not depend on the threads; those in order of ids are the others, sorted.
void check_threads(Scene &scene) {
  const double radius = *std::min_element(scene.particles.radii.begin(), scene.particles.radii.end());
  scene.def.skin = 0.5 * radius;
  const double step = 0.05 * radius;
  std::vector<Pairs> alone = lists_of_steps(scene, step, 1, HG_ORDER_GRID);
  const auto require_lists = [&](const char *what, int threads, int32_t order) {
    const std::vector<Pairs> lists = lists_of_steps(scene, step, threads, order);
    require(lists.size() == alone.size(), "fewer lists");
    for (size_t k = 0; k < lists.size(); k++) require_same(what, lists[k], alone[k]);
  };
  for (const int threads : {2, 5}) require_lists("threads", threads, HG_ORDER_GRID);
  for (Pairs &pairs : alone) pairs = sorted(pairs);
  for (const int threads : {1, 2, 5}) require_lists("order of ids", threads, HG_ORDER_ID);
}

void order_for_any_number_of_threads(void **) {
  assert_true(holds(5, [](uint64_t seed) {
    Rng rng(seed);
    Scene scene = periodic_scene(rng, 3, 5, 22000, Sizes::kUniformVolume);
    check_threads(scene);
    scene = tilted_scene(rng, 3, 7, 22000, Sizes::kUniformVolume);
    check_threads(scene);
    scene = many_images_scene(rng, 3, 7, 22000, Sizes::kUniformVolume);
    check_threads(scene);
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(same_pairs_after_any_step), cmocka_unit_test(coarse_places),
                              cmocka_unit_test(order_for_any_number_of_threads)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
