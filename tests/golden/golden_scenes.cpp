// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/golden/golden_scenes.hpp"

#include "tests/support/rng.hpp"

#include <cmath>

namespace golden {
namespace {

using Particles = particles::ParticleSet;
using hgtest::Rng;

enum class Law { kMono, kTwo, kUniformVolume };

double draw_radius(Rng &rng, Law law, double ratio) {
  switch (law) {
    case Law::kMono:
      return 1;
    case Law::kTwo:
      return rng.chance(0.02) ? ratio : 1;
    case Law::kUniformVolume:
      return 1 / std::sqrt(1 - rng.uniform() * (1 - 1 / (ratio * ratio)));
  }
  return 1;
}

// A cube with its lower corner at `low`.
Particles thrown(Rng &rng, int dimension, int count, Law law, double ratio, double low, double edge) {
  Particles particles;
  particles.dimension = dimension;
  for (int i = 0; i < count; i++) {
    double center[3];
    for (double &x : center) x = low + rng.uniform() * edge;
    particles.add(center, draw_radius(rng, law, ratio));
  }
  return particles;
}

Particles lattice(int side) {
  Particles particles;
  for (int at = 0; at < side * side * side; at++) {
    const double center[3] = {0.1 * (at % side), 0.1 * (at / side % side), 0.1 * static_cast<double>(at / side / side)};
    particles.add(center, 0.05);
  }
  return particles;
}

Particles clusters(Rng &rng, int count) {
  Particles particles;
  const double places[4] = {-1e12, 0, 3e11, 1e12};
  for (int i = 0; i < count; i++) {
    const double place = places[rng.below(4)];
    const double center[3] = {place + 8 * rng.uniform(), -place + 8 * rng.uniform(), place + 8 * rng.uniform()};
    particles.add(center, 0.25 + 0.5 * rng.uniform());
  }
  return particles;
}

Particles giants_over_dust(Rng &rng, int count) {
  Particles particles = thrown(rng, 3, count, Law::kMono, 1, -2, 4);
  for (double &r : particles.radii) r = 1e-4;
  for (int i = 0; i < 3; i++) {
    const double center[3] = {rng.uniform(), rng.uniform(), rng.uniform()};
    particles.add(center, 1);
  }
  return particles;
}

GoldenScene scene(const char *name, Particles particles) {
  GoldenScene result{name, hg_default_grid_def(), std::move(particles)};
  result.def.dimension = result.particles.dimension;
  return result;
}

GoldenScene periodic(const char *name, Particles particles, int axes, double low, double edge) {
  GoldenScene result = scene(name, std::move(particles));
  for (int k = 0; k < result.def.dimension; k++) {
    result.def.periodic[k] = axes >> k & 1;
    result.def.box_min[k] = low;
    result.def.box_max[k] = low + edge;
  }
  return result;
}

}  // namespace

std::vector<GoldenScene> all_scenes() {
  Rng rng(20121031);
  std::vector<GoldenScene> scenes;
  scenes.push_back(scene("mono", thrown(rng, 3, 2000, Law::kMono, 1, 0, 24)));
  scenes.push_back(scene("two-sizes-2d", thrown(rng, 2, 2000, Law::kTwo, 10, -50, 130)));
  // Enough particles for threads to share.
  scenes.push_back(scene("uniform-volume-50", thrown(rng, 3, 24000, Law::kUniformVolume, 50, 0, 240)));
  scenes.push_back(scene("uniform-volume-50-paper", thrown(rng, 3, 2000, Law::kUniformVolume, 50, 0, 105)));
  scenes.back().def.level_rule = HG_LEVELS_PAPER;
  scenes.push_back(periodic("periodic", thrown(rng, 3, 2000, Law::kUniformVolume, 5, 0, 30), 7, 0, 30));
  scenes.push_back(periodic("periodic-x-2d", thrown(rng, 2, 2000, Law::kTwo, 5, 1000, 90), 1, 1000, 90));
  scenes.push_back(scene("touching-lattice", lattice(12)));
  scenes.push_back(scene("clusters", clusters(rng, 2000)));
  scenes.push_back(scene("giants-over-dust", giants_over_dust(rng, 3000)));
  scenes.push_back(scene("far-from-the-origin", thrown(rng, 3, 2000, Law::kUniformVolume, 20, 0x1p50, 60)));
  scenes.push_back(scene("max-range-margin", thrown(rng, 3, 2000, Law::kTwo, 4, 0, 24)));
  scenes.back().def.interaction = HG_MAX_RANGE;
  scenes.back().def.margin = 0.125;
  scenes.push_back(scene("double-lattice", lattice(11)));
  scenes.back().def.accuracy = HG_DOUBLE;
  scenes.push_back(scene("float-lattice", lattice(11)));
  scenes.back().def.accuracy = HG_FLOAT;
  return scenes;
}

}  // namespace golden
