// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A move that is refused leaves no trace: with a bad number in any place, between moves that are taken, a grid goes on
// as one that never heard of it: the same contacts, bit for bit, from the same searches, and what it lent stays.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace hgtest;

constexpr size_t kMost = 1500;  // particles: more than the passes over coordinates take at once

Scene draw(Rng &rng) {
  const int dimension = rng.integer(2, 3), axes = rng.integer(1, dimension == 3 ? 7 : 3);
  const size_t count = rng.chance(0.5) ? 1 + rng.below(kMost) : 1 + rng.below(20);
  Scene scene;
  switch (rng.below(4)) {
    case 0:
      scene = open_scene(rng, dimension, count, Sizes::kUniform, Places::kUniform);
      break;
    case 1:
      scene = periodic_scene(rng, dimension, axes, count, Sizes::kUniform);
      break;
    case 2:
      scene = tilted_scene(rng, dimension, draw_tilted_axes(rng, dimension), count, Sizes::kUniform);
      break;
    default:
      scene = many_images_scene(rng, dimension, axes, std::min<size_t>(count, 100), Sizes::kUniform);
  }
  const double radius = *std::max_element(scene.particles.radii.begin(), scene.particles.radii.end());
  scene.def.skin = rng.chance(0.8) ? radius * rng.uniform(0.1, 1) : 0;
  scene.def.pair_order = rng.integer(HG_ORDER_GRID, HG_ORDER_ID);
  return scene;
}

// What a grid answers, to the bit, and how it came by it.
struct Answer {
  Pairs pairs;
  std::vector<double> numbers;
  int64_t searches, filters, builds, stored;
};

Answer answer_of(const Grid &grid) {
  Answer answer;
  grid.visit_contacts([&](const hg_contact_batch &batch) {
    for (size_t k = 0; k < batch.count; k++) {
      answer.pairs.push_back({batch.a[k], batch.b[k]});
      answer.numbers.insert(answer.numbers.end(),
                            {batch.dx[k], batch.dy[k], batch.dz != nullptr ? batch.dz[k] : 0, batch.reach[k]});
    }
  });
  const hg_grid_stats stats = grid.get_stats();
  answer.searches = stats.search_count;
  answer.filters = stats.filter_count;
  answer.builds = stats.build_count;
  answer.stored = stats.stored_count;
  return answer;
}

void require_same_answer(const std::string &what, const Answer &got, const Answer &expected) {
  require_same(what.c_str(), got.pairs, expected.pairs);
  require(got.numbers == expected.numbers, what + ": other vectors or reaches");
  require(got.searches == expected.searches && got.filters == expected.filters && got.builds == expected.builds &&
              got.stored == expected.stored,
          what + ": answered in another way");
}

// Two grids of the same life, of which one is also asked for what it must refuse.
class Twins {
 public:
  explicit Twins(uint64_t seed)
      : rng_(seed),
        scene_(draw(rng_)),
        tried_(make_grid(scene_.def, scene_.particles)),
        spared_(make_grid(scene_.def, scene_.particles)) {}

  void run() {
    for (int step = 0; step < 6; step++) {
      if (rng_.chance(0.7)) compare();
      const hgrid::View<hg_pair> lent = tried_.query_pairs();
      const Pairs before(lent.begin(), lent.end());
      spared_.query_pairs();
      for (int k = rng_.integer(1, 4); k > 0; k--) refuse();
      require_same("lent", Pairs(lent.begin(), lent.end()), before);
      if (rng_.chance(0.7)) compare();
      Particles &p = scene_.particles;
      p = moved(rng_.chance(0.2) ? 3 : 0.1);
      const double *radii = rng_.chance(0.5) ? p.radii.data() : nullptr;
      for (Grid *grid : {&tried_, &spared_}) grid->move(p.count(), p.centers.data(), radii);
    }
    compare();
  }

 private:
  void compare() { require_same_answer(scene_.name, answer_of(tried_), answer_of(spared_)); }

  Particles moved(double share) {
    Particles particles = scene_.particles;
    const double step = share * (scene_.def.skin > 0 ? scene_.def.skin : particles.radii[0]);
    for (double &x : particles.centers) x += rng_.uniform(-step, step) / 2;
    return particles;
  }

  void refuse() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const double bad[] = {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity};
    Particles wrong = moved(rng_.chance(0.5) ? 0.1 : 10);
    const bool with_radii = rng_.chance(0.5);
    size_t count = wrong.count();
    // The first, the last, or any.
    const size_t row = rng_.chance(0.3) ? 0 : (rng_.chance(0.3) ? count - 1 : rng_.below(count));
    hg_status expected = HG_ERR_ARGUMENT;
    if (rng_.chance(0.1)) {
      count = rng_.chance(0.5) ? count - 1 : count + 1;
      wrong.centers.resize(wrong.centers.size() + static_cast<size_t>(wrong.dimension));
      wrong.radii.push_back(1);
    } else if (with_radii && rng_.chance(0.4)) {
      wrong.radii[row] = rng_.chance(0.25) ? -1 : bad[rng_.below(3)];
    } else if (scene_.def.periodic[0] != 0 && rng_.chance(0.3)) {
      wrong.centers[row * static_cast<size_t>(wrong.dimension)] = 1e300;
      expected = HG_ERR_LIMIT;
    } else {
      wrong.centers[row * static_cast<size_t>(wrong.dimension) + rng_.below(static_cast<uint64_t>(wrong.dimension))] =
          bad[rng_.below(3)];
    }
    const hg_status status = status_of([&] { move(wrong, count, with_radii); });
    require(status == expected, scene_.name + ": status " + std::to_string(status));
  }

  void move(const Particles &particles, size_t count, bool with_radii) {
    const double *radii = with_radii ? particles.radii.data() : nullptr;
    if (rng_.chance(0.5)) {
      tried_.move(count, particles.centers.data(), radii);
      return;
    }
    const auto stride = static_cast<int64_t>(sizeof(double)) * particles.dimension;
    hg_array centers[3];
    for (int axis = 0; axis < particles.dimension; axis++) {
      centers[axis] = {particles.centers.data() + axis, stride, HG_REAL64, 0};
    }
    const hg_array radius{radii, sizeof(double), HG_REAL64, 0};
    tried_.move_arrays(count, centers, with_radii ? &radius : nullptr);
  }

  Rng rng_;
  Scene scene_;
  Grid tried_, spared_;
};

void no_trace(void **) {
  assert_true(sweep(400, [](uint64_t seed) { Twins(seed).run(); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(no_trace)};
  return cmocka_run_group_tests_name("refused_moves", tests, nullptr, nullptr);
}
