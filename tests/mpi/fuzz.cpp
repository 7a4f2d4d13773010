// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_mpi_fuzz ROUNDS [SEED]: random scenes, new owners and steps; in each the pairs of all ranks together are those
// that brute force finds, none missing, none twice. Under mpirun, on any number of ranks.
#include "tests/mpi/scene.hpp"

#include <algorithm>
#include <cstdlib>

namespace {

using namespace hgtest::mpi;
using hgtest::Rng;

struct Sums {
  int64_t checks = 0, pairs = 0, wrong = 0, choices = 0, updates = 0, balances = 0, ghosts = 0, opened = 0;
};

bool is_open(const hg_grid_def &def) { return def.periodic[0] == 0 && def.periodic[1] == 0 && def.periodic[2] == 0; }

// A small step of all, sometimes a large one of a few; some wrap, some grow.
bool step(Scene &scene, Rng &rng) {
  const size_t d = scene.dimension();
  const bool wrap = rng.chance(0.5), grow = rng.chance(0.3), one_jumps = rng.chance(0.2);
  const double way = scene.def.skin > 0 ? 0.2 * scene.def.skin : 0.01;
  const size_t jumper = rng.below(std::max<size_t>(1, scene.count()));
  for (size_t k = 0; k < scene.count(); k++) {
    for (size_t axis = 0; axis < d; axis++) {
      double &x = scene.centers[k * d + axis];
      x += rng.uniform(-way, way);
      const double low = scene.def.box_min[axis], high = scene.def.box_max[axis];
      if (one_jumps && k == jumper) x = rng.uniform(low, high);
      // Along one edge of the cell, as a code does that wraps.
      if (!wrap || scene.def.periodic[axis] == 0 || (x >= low && x < high)) continue;
      const double n = x < low ? 1 : -1;
      const double edges[3][3] = {
          {high - low, 0, 0}, {scene.def.tilt[0], high - low, 0}, {scene.def.tilt[1], scene.def.tilt[2], high - low}};
      for (size_t along = 0; along <= axis; along++) scene.centers[k * d + along] += n * edges[axis][along];
    }
    // The order of sizes changes. In a periodic cell none may grow, as it could get too short.
    if (grow) scene.radii[k] *= rng.uniform(0.95, is_open(scene.def) ? 1.05 : 1.0);
  }
  return grow;
}

// New owners, and a column that follows the particles.
bool balance(const World &world, Checks &checks, bool given_weights) {
  std::vector<int64_t> before = world.all_gids();
  const auto owned = static_cast<size_t>(world.stats().owned_count);
  before.resize(owned);
  const std::vector<double> weights(owned, 2.5);
  size_t count = 0;
  const hg_status status = hg_mpi_balance(world.get(), given_weights ? weights.data() : nullptr, &count);
  if (status == HG_ERR_STATE || status == HG_ERR_REMOTE) return false;  // no Zoltan
  need(status);
  std::vector<int64_t> after(count), gids = world.all_gids();
  need(hg_mpi_migrate(world.get(), sizeof(int64_t), before.data(), after.data()));
  gids.resize(count);
  checks.that(gids == after, "migrated rows follow their particles");
  return true;
}

// Ghosts have the bits of their owners, and forces come back: each owned row gets one for each of its ghosts.
void check_rows(const Scene &scene, const World &world, Checks &checks) {
  size_t count = 0;
  const int64_t *gids = nullptr;
  const double *centers = nullptr, *radii = nullptr;
  need(hg_mpi_ghosts(world.get(), &count, &gids, nullptr, &centers, &radii));
  const std::vector<size_t> rows = scene.rows_of({gids, gids + count});
  const size_t d = scene.dimension();
  for (size_t k = 0; k < count; k++) {
    checks.that(std::memcmp(centers + k * d, &scene.centers[rows[k] * d], d * sizeof(double)) == 0, "ghosts' centers");
    checks.that(radii[k] == scene.radii[rows[k]], "ghosts' radii");
  }
  std::vector<double> own(static_cast<size_t>(world.stats().owned_count)), ones(count, 1.0);
  need(hg_mpi_reverse_add(world.get(), 1, ones.data(), own.data()));
  double sum = 0;
  for (const double value : own) sum += value;
  checks.that(sum_of(static_cast<int64_t>(sum)) == sum_of(static_cast<int64_t>(count)),
              "as many come back as there are");
}

void one_round(uint64_t seed, int ranks, Checks &checks, Sums &sums) {
  Rng rng(seed);
  Scene scene = random_scene(rng, ranks);
  hg_mpi_def def;
  need(hg_mpi_def_init(&def, sizeof def));
  def.verify = 1;
  def.balancer = rng.chance(0.5) ? HG_MPI_BISECTION : HG_MPI_CURVE;
  const World world(scene.def, MPI_COMM_WORLD, &def);
  hand_out(scene, world);
  const auto check = [&] {
    sums.wrong += wrong_pairs(scene, world, &checks, &sums.pairs);
    sums.checks++;
    check_rows(scene, world, checks);
  };
  check();
  if (rng.chance(0.6) && balance(world, checks, rng.chance(0.5))) {
    sums.balances++;
    check();
  }
  for (int steps = rng.integer(0, 4); steps > 0; steps--) {
    const bool grown = step(scene, rng);
    (void)move_all(scene, world, grown);
    check();
  }
  const hg_mpi_stats stats = world.stats();
  sums.choices += stats.selection_count;
  sums.updates += stats.update_count;
  sums.ghosts += sum_of(stats.ghost_count);
  sums.opened += sum_of(stats.opened_axis_count);
}

}  // namespace

int main(int argc, char **argv) {
  return on_ranks(argc, argv, [&](const Ranks &ranks) {
    const long rounds = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 20;
    const uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    Checks checks;
    Sums sums;
    for (long round = 0; round < rounds; round++) {
      const int64_t wrong = sums.wrong;
      const uint64_t seed = first + static_cast<uint64_t>(round);
      one_round(seed, ranks.size(), checks, sums);
      if (sums.wrong > wrong && ranks.is_first()) {
        std::fprintf(stderr, "seed %llu: %lld pairs are wrong\n", static_cast<unsigned long long>(seed),
                     static_cast<long long>(sums.wrong - wrong));
      }
      checks.that(sums.wrong == wrong, "the pairs of all ranks are those of brute force");
    }
    if (ranks.is_first()) {
      std::printf(
          "%d ranks, %ld rounds, %lld checks of %lld pairs, %lld wrong; ghosts chosen %lld times, updated %lld, "
          "balanced %lld, %lld ghosts, %lld axes opened\n",
          ranks.size(), rounds, static_cast<long long>(sums.checks), static_cast<long long>(sums.pairs),
          static_cast<long long>(sums.wrong), static_cast<long long>(sums.choices),
          static_cast<long long>(sums.updates), static_cast<long long>(sums.balances),
          static_cast<long long>(sums.ghosts), static_cast<long long>(sums.opened));
    }
    return checks.conclude();
  });
}
