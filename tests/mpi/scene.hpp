// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles of all ranks, known to each rank of a test, and the truth about their pairs by brute force.
#pragma once

#include "tests/mpi/ranks.hpp"
#include "tests/support/rng.hpp"

#include <unordered_map>
#include <utility>

namespace hgtest::mpi {

// Two gids, the smaller first.
using GidPair = std::pair<int64_t, int64_t>;

struct Scene {
  hg_grid_def def = hg_default_grid_def();
  std::vector<int64_t> gids;
  std::vector<double> centers, radii;
  std::vector<int32_t> owners, groups, bodies;
  std::vector<std::pair<int32_t, int32_t>> apart;  // groups that do not meet

  size_t count() const { return radii.size(); }
  size_t dimension() const { return static_cast<size_t>(def.dimension); }
  // The rows of these gids.
  std::vector<size_t> rows_of(const std::vector<int64_t> &some) const;
  void add(const std::vector<double> &center, double radius) {
    centers.insert(centers.end(), center.begin(), center.end());
    radii.push_back(radius);
  }
};

// Of any kind that the library promises to handle, the same for one seed and number of ranks.
Scene random_scene(Rng &rng, int ranks);

// All of them, ascending.
std::vector<GidPair> true_pairs(const Scene &scene);

// Gives each rank its particles.
void hand_out(const Scene &scene, const World &world);
// Moves all to where the scene has them now. Whether ghosts were chosen anew.
bool move_all(const Scene &scene, const World &world, bool with_radii);
// Numbers of owned particles from those of all; `width` for each.
template <class T>
std::vector<T> owned_part(const Scene &scene, const World &world, const std::vector<T> &all, size_t width = 1) {
  std::vector<int64_t> gids = world.all_gids();
  gids.resize(static_cast<size_t>(world.stats().owned_count));
  std::vector<T> part;
  for (const size_t row : scene.rows_of(gids)) {
    for (size_t k = 0; k < width; k++) part.push_back(all[row * width + k]);
  }
  return part;
}

// What the ranks find: on the first rank the pairs of all, ascending; on others none.
std::vector<GidPair> found_pairs(const World &world, int32_t index_base, Checks *checks);
// How many pairs are missing, wrong or found twice; the same on all ranks. Adds the true ones to *pairs.
int64_t wrong_pairs(const Scene &scene, const World &world, Checks *checks, int64_t *pairs);

}  // namespace hgtest::mpi
