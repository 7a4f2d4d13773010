// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_mpi_ghosts [COUNT]: the ghosts that ranks have, with owners as a plan on one process deals them out, which must
// come to the same numbers, and with those of Zoltan. Ends with 1 if these need more than docs/evidence/mpi.md says.
#include "programs/ranks/ghosts.hpp"

#include "tests/mpi/scene.hpp"
#include "tests/support/size_laws.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace {

using namespace hgtest::mpi;
using hgrid::mpi::ReachRule;
using hgtest::Rng;

struct System {
  const char *name;
  Scene scene;
  // More ghosts per particle than that on 8 ranks are a fault, for 125 001 particles.
  double most_of_8;
};

// Centres at random in a periodic cube of which spheres would fill 0.62, or in 40 open clouds.
Scene make_scene(const std::vector<double> &radii, bool clouds) {
  Rng rng(7);
  Scene scene;
  double volume = 0;
  for (const double r : radii) volume += 4.0 / 3 * 3.14159265358979 * r * r * r;
  const double length = std::cbrt(volume / 0.62);
  std::vector<double> middles;
  middles.reserve(120);
  for (int k = 0; k < 40 * 3; k++) middles.push_back(rng.uniform(0.0, 10.0 * length));
  for (const double r : radii) {
    std::vector<double> center;
    const size_t cloud = rng.below(40);
    for (size_t axis = 0; axis < 3; axis++) {
      const double place = rng.uniform() * (clouds ? length / std::cbrt(40.0) : length);
      center.push_back(clouds ? middles[cloud * 3 + axis] + place : place);
    }
    scene.add(center, r);
    scene.gids.push_back(static_cast<int64_t>(scene.gids.size()));
  }
  for (int axis = 0; axis < 3 && !clouds; axis++) {
    scene.def.periodic[axis] = 1;
    scene.def.box_max[axis] = length;
  }
  scene.groups.assign(radii.size(), 0);
  scene.bodies.assign(radii.size(), -1);
  return scene;
}

std::vector<System> systems(size_t count) {
  const std::vector<double> wide = hgtest::sample(hgtest::uniform_volume, 50, count);
  return {{"uniform volume, ratio 50, periodic", make_scene(wide, false), 0.12},
          {"equal sizes, periodic", make_scene(std::vector<double>(count, 1.0), false), 0.30},
          {"uniform volume, ratio 50, 40 clouds", make_scene(wide, true), 0.08}};
}

// Dealt out as a plan on one process does (programs/ranks): the ranks hold and exchange exactly what it says.
bool fits_plan(System &system, const Ranks &ranks) {
  particles::ParticleSet set;
  set.centers = system.scene.centers;
  set.radii = system.scene.radii;
  const std::vector<double> ones(set.count(), 1.0);
  system.scene.owners = ranks::bisect(set, ones, ranks.size());
  const ReachRule rule(system.scene.def);
  const ranks::Exchange planned = ranks::exchanges_of(
      rule, ranks::parts_of(set, system.scene.owners, ranks.size()))[static_cast<size_t>(ranks.rank())];
  const World world(system.scene.def);
  hand_out(system.scene, world);
  const hg_mpi_stats stats = world.stats();
  const bool fits = stats.owned_count == planned.owned && stats.ghost_count == planned.ghosts &&
                    stats.send_rank_count == planned.send_ranks && stats.receive_rank_count == planned.receive_ranks;
  if (!fits) {
    std::printf("%s, rank %d: %lld ghosts, planned %lld\n", system.name, ranks.rank(),
                static_cast<long long>(stats.ghost_count), static_cast<long long>(planned.ghosts));
  }
  return fits;
}

// Pairs that the grids of the ranks find, over those that they keep.
double found_over_kept(const Scene &scene, const World &world) {
  hg_grid *grid = nullptr;
  need(hg_create(&scene.def, &grid));
  const std::vector<int64_t> gids = world.all_gids();
  const auto owned = static_cast<size_t>(world.stats().owned_count);
  std::vector<double> centers, radii;
  std::vector<int32_t> groups(gids.size(), 1);
  std::fill(groups.begin(), groups.begin() + static_cast<ptrdiff_t>(owned), 0);
  for (const size_t row : scene.rows_of(gids)) {
    centers.insert(centers.end(), &scene.centers[3 * row], &scene.centers[3 * row] + 3);
    radii.push_back(scene.radii[row]);
  }
  need(hg_set(grid, radii.size(), centers.data(), radii.data()));
  need(hg_set_groups(grid, groups.size(), groups.data()));
  need(hg_set_group_pair(grid, 1, 1, 0));
  size_t found = 0;
  const hg_pair *pairs = nullptr;
  need(hg_query_pairs(grid, &pairs, &found));
  hg_destroy(grid);
  return static_cast<double>(sum_of(static_cast<int64_t>(found))) /
         static_cast<double>(sum_of(world.stats().pair_count));
}

// Ghosts, messages and the work of the search, on the ranks there are.
bool measure(System &system, const Ranks &ranks) {
  for (size_t k = 0; k < system.scene.count(); k++) system.scene.owners[k] = static_cast<int32_t>(k % ranks.size());
  system.scene.def.thread_count = 1;
  const World world(system.scene.def);
  hand_out(system.scene, world);
  const std::vector<double> ones(static_cast<size_t>(world.stats().owned_count), 1.0);
  const hg_status status = hg_mpi_balance(world.get(), ones.data(), nullptr);
  if (status != HG_OK) {
    if (ranks.is_first()) std::printf("not measured: %s\n", hg_last_error());
    return true;
  }
  const hg_pair *pairs = nullptr;
  size_t count = 0;
  need(hg_mpi_query_pairs(world.get(), &pairs, &count));
  const auto pairs_of_ranks = [&] {
    int64_t mine = world.stats().pair_count, most = 0;
    MPI_Allreduce(&mine, &most, 1, MPI_INT64_T, MPI_MAX, MPI_COMM_WORLD);
    return static_cast<double>(most) * ranks.size() / static_cast<double>(sum_of(mine));
  };
  const double uneven = pairs_of_ranks(), found = found_over_kept(system.scene, world);
  const double all = static_cast<double>(system.scene.count());
  const double ghosts = static_cast<double>(sum_of(world.stats().ghost_count)) / all;
  const int64_t neighbours = sum_of(world.stats().send_rank_count), kept = sum_of(world.stats().pair_count);
  const int64_t sent = sum_of(world.stats().sent_byte_count);
  need(hg_mpi_move(world.get(), static_cast<size_t>(world.stats().owned_count),
                   owned_part(system.scene, world, system.scene.centers, 3).data(),
                   owned_part(system.scene, world, system.scene.radii).data(), nullptr));
  const int64_t update = sum_of(world.stats().sent_byte_count) - sent;
  need(hg_mpi_balance(world.get(), nullptr, nullptr));
  need(hg_mpi_query_pairs(world.get(), &pairs, &count));
  const double weighted = pairs_of_ranks();
  if (!ranks.is_first()) return true;
  std::printf("| %s | %d | %.3f | %lld | %.1f | %.2f | %.2f -> %.2f | %.2f |\n", system.name, ranks.size(), ghosts,
              static_cast<long long>(kept), static_cast<double>(neighbours) / ranks.size(),
              static_cast<double>(update) / 1e6, uneven, weighted, found);
  // As particles at surfaces of parts go with their number.
  return ghosts <= system.most_of_8 * std::cbrt(125001 / all) && found <= 1.25;
}

}  // namespace

int main(int argc, char **argv) {
  return on_ranks(argc, argv, [&](const Ranks &ranks) {
    const size_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 125001;
    bool fits = true;
    if (ranks.is_first()) {
      std::printf(
          "| system | ranks | ghosts | pairs | neighbours | MB an update | pairs, largest over mean | found over "
          "kept |\n|---|---|---|---|---|---|---|---|\n");
    }
    for (System &system : systems(count)) {
      fits = fits_plan(system, ranks) && fits;
      fits = measure(system, ranks) && fits;
    }
    Checks checks;
    checks.that(fits, "as planned, and as few ghosts as stated");
    return checks.conclude();
  });
}
