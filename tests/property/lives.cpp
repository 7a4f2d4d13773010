// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Lives of grids of every kind against the oracle: hgrid_lives [COUNT [FIRST]], 500 from the first if not given. A life
// is told by its number alone. Prints how many answers were compared; exit code 1 if any was wrong, with the numbers of
// those lives.
#include "tests/property/life.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace {

using namespace hgtest;

// Most particles into clumps: the groups keep how densely they are packed, in a part of the space and of the size that
// they had. The others stay, as giants among dust.
void gather(Rng &rng, Scene &scene) {
  Particles particles = scene.particles;
  const auto dimension = static_cast<size_t>(particles.dimension);
  const double keep = rng.uniform(0, 0.3), size = std::pow(10, rng.uniform(-6, 0));
  const size_t groups = 1 + rng.below(3);
  for (size_t i = groups; i < particles.count(); i++) {
    if (rng.chance(keep)) continue;
    particles.radii[i] *= size;
    const size_t middle = rng.below(groups);
    for (size_t k = 0; k < dimension; k++) {
      double &x = particles.centers[i * dimension + k];
      const double to = particles.centers[middle * dimension + k];
      x = to + size * (x - to);
    }
  }
  if (!has_far_particles(scene.def, particles)) scene.particles = particles;
}

// Enough particles for several threads. They fill space evenly and x is open: the oracle sweeps along it.
Scene draw_large(Rng &rng) {
  const size_t count = 20000 + rng.below(5000);
  Scene scene = rng.chance(0.5) ? open_scene(rng, rng.integer(2, 3), count, Sizes::kUniform, Places::kUniform)
                                : tilted_scene(rng, 3, 6, count, Sizes::kUniform);
  draw_levels(rng, scene);
  scene.def.thread_count = 2;
  return scene;
}

Scene draw(Rng &rng, bool large) {
  Scene scene;
  do {
    scene = large ? draw_large(rng) : any_scene(rng, rng.below(rng.chance(0.9) ? 100 : 400));
  } while (has_far_particles(scene.def, scene.particles));
  if (!large && rng.chance(0.3)) gather(rng, scene);
  hg_grid_def &def = scene.def;
  def.accuracy = rng.chance(0.3) ? HG_DOUBLE : HG_EXACT;
  def.pair_order = rng.integer(HG_ORDER_GRID, HG_ORDER_ID);
  // Of the mean radius: nothing, less than the rounding of places, usual ones, longer than all.
  constexpr double kSkins[] = {0, 0, 0, 1e-6, 0.02, 0.3, 1, 10, 1e6};
  def.skin = kSkins[rng.below(sizeof kSkins / sizeof *kSkins)] * mean_radius(scene.particles);
  return scene;
}

struct Sum {
  uint64_t lives = 0, compared = 0, wrong = 0;
  int64_t searched = 0, filtered = 0;
};

void live(uint64_t number, Sum &sum) {
  const bool right = holds(number, [&](uint64_t) {
    Rng rng(number);
    const bool large = number % 500 == 499;
    Scene scene = draw(rng, large);
    const double box_changes = rng.chance(0.5) ? 0 : rng.uniform();
    const double company_changes = rng.chance(0.5) ? 0 : rng.uniform();
    Life life(rng.next(), std::move(scene), box_changes, company_changes);
    life.run(large ? 3 : 20);
    sum.compared += life.compared();
    sum.searched += life.stats().search_count;
    sum.filtered += life.stats().filter_count;
  });
  sum.lives++;
  sum.wrong += right ? 0 : 1;
}

}  // namespace

int main(int argc, char **argv) {
  const uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 500;
  const uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 0;
  Sum sum;
  for (uint64_t number = first; number < first + count; number++) live(number, sum);
  std::printf("%llu lives, %llu answers compared, %llu lives wrong; %lld searches, %lld from stored candidates\n",
              static_cast<unsigned long long>(sum.lives), static_cast<unsigned long long>(sum.compared),
              static_cast<unsigned long long>(sum.wrong), static_cast<long long>(sum.searched),
              static_cast<long long>(sum.filtered));
  return sum.wrong == 0 ? 0 : 1;
}
