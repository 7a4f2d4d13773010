// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Prints a hash of the pairs of some seeded scenes, in the order and the bytes in which the library gives them. Two
// machines, instruction sets or builds must print the same.
#include "tests/support/compare.hpp"
#include "tests/support/rng.hpp"

#include <cinttypes>
#include <cstdio>

namespace {

using namespace hgtest;

// FNV-1a (Fowler, Noll, Vo) over the ids, lowest byte first on any machine.
uint64_t hash_of(const hg_pair *pairs, size_t count) {
  uint64_t hash = 0xcbf29ce484222325U;
  for (size_t k = 0; k < count; k++) {
    for (const int32_t id : {pairs[k].a, pairs[k].b}) {
      for (int byte = 0; byte < 4; byte++) {
        hash = (hash ^ (static_cast<uint32_t>(id) >> (8 * byte) & 0xffU)) * 0x100000001b3U;
      }
    }
  }
  return hash;
}

// Positions and radii by sums, products and quotients alone, which are the same on every machine with IEEE doubles.
Particles fill(Rng &rng, int dimension, double size_ratio) {
  Particles particles;
  particles.dimension = dimension;
  const int count = rng.integer(500, 4000);
  const double spacing = dimension == 3 ? 0.08 : 0.02;
  for (int i = 0; i < count; i++) {
    double center[3];
    for (double &x : center) x = rng.chance(0.1) ? rng.integer(0, 8) * 0.125 : rng.uniform();
    const double largest = spacing * (rng.chance(0.9) ? 1 : 3);
    particles.add(center, largest / (size_ratio - (size_ratio - 1) * rng.uniform()));
  }
  return particles;
}

hg_grid_def definition(Rng &rng, int dimension) {
  hg_grid_def def = hg_default_grid_def();
  def.dimension = dimension;
  def.thread_count = rng.integer(1, 2);
  def.interaction = rng.chance(0.3) ? HG_MAX_RANGE : HG_CONTACT;
  def.accuracy = rng.integer(HG_EXACT, HG_FLOAT);
  def.margin = rng.chance(0.3) ? 0.001 : 0;
  for (int k = 0; k < dimension; k++) {
    def.periodic[k] = rng.chance(0.4) ? 1 : 0;
    def.box_max[k] = 1;
  }
  return def;
}

uint64_t query(const Grid &grid, size_t &count) {
  const hgrid::View<hg_pair> pairs = grid.query_pairs();
  count = pairs.size();
  return hash_of(pairs.data(), count);
}

// A search, and one step of small moves, which stored candidates answer where there is a skin.
void print_scene(uint64_t seed) {
  Rng rng(seed);
  const int dimension = rng.integer(2, 3);
  const double size_ratio = rng.chance(0.3) ? 1 : rng.uniform(2, 100);
  hg_grid_def def = definition(rng, dimension);
  def.skin = rng.chance(0.7) ? 0.002 : 0;
  Particles particles = fill(rng, dimension, size_ratio);
  Grid grid = make_grid(def, particles);
  size_t count = 0, moved_count = 0;
  const uint64_t hash = query(grid, count);
  for (double &x : particles.centers) x += rng.uniform(-0.0003, 0.0003);
  grid.move(particles.count(), particles.centers.data());
  const uint64_t moved_hash = query(grid, moved_count);
  std::printf("seed %2" PRIu64 ": %dD, %5zu particles, %6zu pairs, hash %016" PRIx64 "; moved: %6zu, %016" PRIx64 "\n",
              seed, dimension, particles.count(), count, hash, moved_count, moved_hash);
}

}  // namespace

int main() { return sweep(40, print_scene) ? 0 : 1; }
