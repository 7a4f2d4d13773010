// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Inputs made to cost a grid time or memory. No clock: the work is counted, by hg_get_stats, against the particles and
// the pairs that there are.
#include "tests/support/compare.hpp"
#include "tests/support/rng.hpp"

#include <cmath>
#include <initializer_list>
#include <utility>

namespace {

using namespace hgtest;

struct Counted {
  Pairs pairs;
  hg_grid_stats stats;
};

Counted count_pairs(const hg_grid_def &def, const Particles &particles) {
  const Grid grid = make_grid(def, particles);
  Pairs pairs = sorted_pairs_of(grid);
  return {std::move(pairs), grid.get_stats()};
}

// Tests and places grow with the particles and pairs alone; the factors are several times what is needed now.
void require_bounded(const std::string &what, const Counted &counted, double tests_per_particle) {
  const hg_grid_stats &s = counted.stats;
  const double particles = static_cast<double>(s.particle_count), pairs = static_cast<double>(s.pair_count);
  const double tests = static_cast<double>(s.candidate_count);
  require(tests <= tests_per_particle * particles + 4 * pairs,
          what + ": " + std::to_string(s.candidate_count) + " tests for " + std::to_string(s.particle_count) +
              " particles and " + std::to_string(s.pair_count) + " pairs");
  require(static_cast<double>(s.cell_count + s.row_count) <= 16 * particles + 10000,
          what + ": " + std::to_string(s.cell_count) + " cells for " + std::to_string(s.particle_count) + " particles");
  require(static_cast<double>(s.byte_count) <= 512 * particles + 64 * pairs + 1e6,
          what + ": " + std::to_string(s.byte_count) + " bytes for " + std::to_string(s.particle_count) + " particles");
}

void require_exact_and_bounded(const std::string &what, const Particles &particles, double tests_per_particle) {
  for (const int32_t rule : {HG_LEVELS_AUTO, HG_LEVELS_PAPER}) {
    hg_grid_def def = hg_default_grid_def();
    def.thread_count = 1;
    def.level_rule = rule;
    const Counted counted = count_pairs(def, particles);
    require_same(what.c_str(), counted.pairs, swept_pairs(def, particles, exact_interact));
    require_bounded(what + ", rule " + std::to_string(rule), counted, tests_per_particle);
  }
}

Particles cloud(Rng &rng, int count, double half_width, double radius) {
  Particles particles;
  for (int i = 0; i < count; i++) {
    double center[3];
    for (double &x : center) x = rng.uniform(-half_width, half_width);
    particles.add(center, radius);
  }
  return particles;
}

// One giant over a hundred thousand particles a million times smaller, most of them inside it: it must meet particles,
// not the 10^18 cells of their size that it covers.
void giant_over_dust(void **) {
  assert_true(holds(1, [](uint64_t seed) {
    Rng rng(seed);
    Particles particles = cloud(rng, 100000, 1.1, 1e-6);
    const double origin[3] = {0, 0, 0};
    particles.add(origin, 1);
    require_exact_and_bounded("giant over dust", particles, 8);
  }));
}

// The dust lies close together, so that its cells are as fine as the coordinates of the search allow.
void giant_over_crowded_dust(void **) {
  assert_true(holds(2, [](uint64_t seed) {
    Rng rng(seed);
    for (const double ratio : {1e6, 1e9, 1e12}) {
      const double radius = 1 / ratio;
      Particles particles = cloud(rng, 20000, 50 * radius, radius);
      const double origin[3] = {0.5, 0, 0};
      particles.add(origin, 1);
      require_exact_and_bounded("crowded dust, ratio " + std::to_string(ratio), particles, 100);
    }
  }));
}

// One giant far from equal spheres: the space that is filled is a tiny part of the bounding box.
void giant_far_away(void **) {
  assert_true(holds(4, [](uint64_t seed) {
    Rng rng(seed);
    Particles particles = cloud(rng, 20000, 65, 1);
    const double origin[3] = {1e6, 0, 0};
    particles.add(origin, 1e5);
    require_exact_and_bounded("giant far away", particles, 100);
  }));
}

// As many particles in each decade of sizes, over six decades, at the density of a loose packing.
void power_law_at_ratio_1e6(void **) {
  assert_true(holds(3, [](uint64_t seed) {
    Rng rng(seed);
    constexpr int kCount = 50000;
    std::vector<double> radii;
    double volume = 0;
    for (int i = 0; i < kCount; i++) {
      radii.push_back(std::pow(10, -6.0 * i / (kCount - 1)));
      volume += 4.0 / 3 * 3.14159265358979 * radii.back() * radii.back() * radii.back();
    }
    const double edge = std::cbrt(volume / 0.6);
    Particles particles;
    for (const double radius : radii) {
      double center[3];
      for (double &x : center) x = rng.uniform(0, edge);
      particles.add(center, radius);
    }
    require_exact_and_bounded("power law", particles, 100);
  }));
}

// N (N - 1) / 2 pairs, in which each id comes N - 1 times; visited, they are never in memory together.
void ten_thousand_at_one_point(void **) {
  assert_true(holds(0, [](uint64_t) {
    constexpr int64_t kCount = 10000;
    Particles particles;
    const double center[3] = {1, 2, 3};
    for (int i = 0; i < kCount; i++) particles.add(center, 0.1);
    const Grid grid = make_grid(hg_default_grid_def(), particles);
    size_t pairs = 0, batches = 0;
    int64_t sum = 0;
    grid.visit_pairs([&](hgrid::View<hg_pair> batch) {
      pairs += batch.size();
      batches++;
      for (const hg_pair &pair : batch) sum += pair.a + pair.b;
    });
    require(pairs == kCount * (kCount - 1) / 2, std::to_string(pairs) + " pairs");
    require(sum == kCount * (kCount - 1) / 2 * (kCount - 1), "wrong ids");
    require(batches > 1, "all pairs in one batch");
    const hg_grid_stats stats = grid.get_stats();
    require(stats.candidate_count == kCount * (kCount - 1) / 2, "pairs were tested twice");
    require(stats.byte_count < 512 * kCount, "the pairs were stored");
  }));
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSlowBuild = true;
#else
constexpr bool kSlowBuild = false;
#endif

// Counts and offsets of pairs have 64 bits.
void more_than_2_31_pairs(void **) {
  if (kSlowBuild) skip();
  assert_true(holds(0, [](uint64_t) {
    constexpr int64_t kCount = 66000, kPairs = kCount * (kCount - 1) / 2;
    static_assert(kPairs > INT32_MAX, "too few for this test");
    Particles particles;
    const double center[3] = {1, 2, 3};
    for (int i = 0; i < kCount; i++) particles.add(center, 0.1);
    const Grid grid = make_grid(hg_default_grid_def(), particles);
    int64_t found = 0;
    grid.visit_pairs([&](hgrid::View<hg_pair> batch) { found += static_cast<int64_t>(batch.size()); });
    require(found == kPairs, std::to_string(found) + " pairs visited");
    const hg_grid_stats stats = grid.get_stats();
    require(stats.pair_count == kPairs, std::to_string(stats.pair_count) + " pairs counted");
  }));
}

// No two particles near each other: nothing to test, and memory for the particles, not for the space between.
void sparse_cloud(void **) {
  assert_true(holds(4, [](uint64_t seed) {
    Rng rng(seed);
    require_exact_and_bounded("sparse cloud", cloud(rng, 20000, 5e5, 0.5), 1);
  }));
}

// A crowd, and particles far away that make a table of cells coarse.
void crowd_with_outliers(void **) {
  assert_true(holds(5, [](uint64_t seed) {
    Rng rng(seed);
    Particles particles = cloud(rng, 20000, 15, 0.5);
    const double far[3][3] = {{1e9, 0, 0}, {-1e9, 1e9, 5}, {3, 4, -1e12}};
    for (const auto &center : far) particles.add(center, 0.5);
    require_exact_and_bounded("crowd with outliers", particles, 100);
  }));
}

// Lattices whose strides are powers of two, mirrored about the origin: coordinates that hash functions by shifts and
// products put into few slots. At each point a triple of which two pairs touch and none overlaps, and one overlap.
void strided_lattices(void **) {
  assert_true(holds(0, [](uint64_t) {
    for (const double stride : {0x1p3, 0x1p16, 0x1p32, 0x1p44}) {
      Particles particles;
      for (int at = 0; at < 20 * 20 * 20; at++) {
        const double center[3] = {stride * (at % 20 - 10), stride * (at / 20 % 20 - 10),
                                  stride * static_cast<double>(at / 400 - 10)};
        for (const double offset : {0.0, 1.0, 2.0, 2.5}) {
          const double moved[3] = {center[0] + offset, center[1], center[2]};
          particles.add(moved, 0.5);
        }
      }
      require_exact_and_bounded("stride " + std::to_string(stride), particles, 16);
    }
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(giant_over_dust),
                              cmocka_unit_test(giant_over_crowded_dust),
                              cmocka_unit_test(giant_far_away),
                              cmocka_unit_test(power_law_at_ratio_1e6),
                              cmocka_unit_test(ten_thousand_at_one_point),
                              cmocka_unit_test(more_than_2_31_pairs),
                              cmocka_unit_test(sparse_cloud),
                              cmocka_unit_test(crowd_with_outliers),
                              cmocka_unit_test(strided_lattices)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
