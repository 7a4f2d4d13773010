// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/mpi/scene.hpp"

#include "oracle/pairs.hpp"

#include <algorithm>
#include <iterator>

namespace hgtest::mpi {
namespace {

particles::ParticleSet as_set(const Scene &scene) {
  particles::ParticleSet set;
  set.dimension = scene.def.dimension;
  set.centers = scene.centers;
  set.radii = scene.radii;
  return set;
}

bool may_pair(const Scene &scene, size_t i, size_t j) {
  const int32_t a = scene.groups[i], b = scene.groups[j];
  if (a < 0 || b < 0) return false;
  for (const auto &[p, q] : scene.apart) {
    if ((a == p && b == q) || (a == q && b == p)) return false;
  }
  return scene.bodies[i] < 0 || scene.bodies[i] != scene.bodies[j];
}

}  // namespace

std::vector<size_t> Scene::rows_of(const std::vector<int64_t> &some) const {
  std::unordered_map<int64_t, size_t> row_of;
  for (size_t k = 0; k < gids.size(); k++) row_of.emplace(gids[k], k);
  std::vector<size_t> rows;
  rows.reserve(some.size());
  for (const int64_t gid : some) rows.push_back(row_of.at(gid));
  return rows;
}

std::vector<GidPair> true_pairs(const Scene &scene) {
  hg_grid_def def = scene.def;
  def.index_base = 0;
  std::vector<GidPair> pairs;
  for (const hg_pair &pair : oracle::all_pairs(def, as_set(scene), oracle::exact_interact)) {
    const auto i = static_cast<size_t>(pair.a), j = static_cast<size_t>(pair.b);
    if (may_pair(scene, i, j)) pairs.emplace_back(std::minmax(scene.gids[i], scene.gids[j]));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

void hand_out(const Scene &scene, const World &world) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const size_t d = scene.dimension();
  std::vector<int64_t> gids;
  std::vector<double> centers, radii;
  std::vector<int32_t> groups, bodies;
  for (size_t k = 0; k < scene.count(); k++) {
    if (scene.owners[k] != rank) continue;
    gids.push_back(scene.gids[k]);
    centers.insert(centers.end(), &scene.centers[k * d], &scene.centers[k * d] + d);
    radii.push_back(scene.radii[k]);
    groups.push_back(scene.groups[k]);
    bodies.push_back(scene.bodies[k]);
  }
  need(hg_mpi_set(world.get(), gids.size(), gids.data(), centers.data(), radii.data()));
  for (const auto &[a, b] : scene.apart) need(hg_mpi_set_group_pair(world.get(), a, b, 0));
  need(hg_mpi_set_groups(world.get(), gids.size(), groups.data()));
  need(hg_mpi_set_bodies(world.get(), gids.size(), bodies.data()));
}

bool move_all(const Scene &scene, const World &world, bool with_radii) {
  const std::vector<double> centers = owned_part(scene, world, scene.centers, scene.dimension());
  const std::vector<double> radii = owned_part(scene, world, scene.radii);
  int32_t changed = -1;
  need(hg_mpi_move(world.get(), radii.size(), centers.data(), with_radii ? radii.data() : nullptr, &changed));
  return changed == 1;
}

std::vector<GidPair> found_pairs(const World &world, int32_t index_base, Checks *checks) {
  const std::vector<int64_t> gids = world.all_gids();
  const hg_pair *pairs = nullptr;
  size_t count = 0;
  need(hg_mpi_query_pairs(world.get(), &pairs, &count));
  std::vector<int64_t> mine;
  for (size_t k = 0; k < count; k++) {
    const int32_t a = pairs[k].a - index_base, b = pairs[k].b - index_base;
    checks->that(a < b && a < world.stats().owned_count, "a < b and a is owned");
    const GidPair pair = std::minmax(gids[static_cast<size_t>(a)], gids[static_cast<size_t>(b)]);
    mine.push_back(pair.first);
    mine.push_back(pair.second);
  }
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  std::vector<int> counts(static_cast<size_t>(size)), places(static_cast<size_t>(size));
  const int length = static_cast<int>(mine.size());
  MPI_Gather(&length, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  int total = 0;
  for (size_t k = 0; k < counts.size(); k++) {
    places[k] = total;
    total += counts[k];
  }
  std::vector<int64_t> all(static_cast<size_t>(total));
  MPI_Gatherv(mine.data(), length, MPI_INT64_T, all.data(), counts.data(), places.data(), MPI_INT64_T, 0,
              MPI_COMM_WORLD);
  std::vector<GidPair> found;
  for (size_t k = 0; k + 1 < all.size(); k += 2) found.emplace_back(all[k], all[k + 1]);
  std::sort(found.begin(), found.end());
  return found;
}

int64_t wrong_pairs(const Scene &scene, const World &world, Checks *checks, int64_t *pairs) {
  const std::vector<GidPair> found = found_pairs(world, scene.def.index_base, checks);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  int64_t told[2] = {0, 0};
  if (rank == 0) {
    const std::vector<GidPair> truth = true_pairs(scene);
    std::vector<GidPair> wrong;
    // Of a pair found twice one is left over.
    std::set_symmetric_difference(truth.begin(), truth.end(), found.begin(), found.end(), std::back_inserter(wrong));
    told[0] = static_cast<int64_t>(wrong.size());
    told[1] = static_cast<int64_t>(truth.size());
  }
  MPI_Bcast(told, 2, MPI_INT64_T, 0, MPI_COMM_WORLD);
  if (pairs != nullptr) *pairs += told[1];
  return told[0];
}

}  // namespace hgtest::mpi
