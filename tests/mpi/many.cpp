// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_mpi_many [SELECTIONS [COUNT]]: ghosts are chosen so many times that ids which were never used again would run
// out; the pairs stay those of the start.
#include "tests/mpi/scene.hpp"

#include <cstdlib>

namespace {

using namespace hgtest::mpi;

// A ring of spheres that touch both neighbours, dealt out in turn, turned by a whole period again and again.
int choose_again(const Ranks &ranks, int64_t selections, int64_t count) {
  hg_grid_def def = hg_default_grid_def();
  def.thread_count = 1;
  def.periodic[0] = 1;
  def.box_max[0] = static_cast<double>(count);
  const World world(def);
  std::vector<int64_t> gids;
  std::vector<double> centers, radii;
  for (int64_t k = ranks.rank(); k < count; k += ranks.size()) {
    gids.push_back(k);
    centers.insert(centers.end(), {static_cast<double>(k), 0, 0});
    radii.push_back(0.6);
  }
  need(hg_mpi_set(world.get(), gids.size(), gids.data(), centers.data(), radii.data()));
  Checks checks;
  for (int64_t k = 0; k < selections; k++) {
    for (size_t x = 0; x < centers.size(); x += 3) centers[x] += k % 2 == 0 ? 0.25 : -0.25;
    int32_t changed = 0;
    need(hg_mpi_move(world.get(), gids.size(), centers.data(), nullptr, &changed));
    if (changed != 1) checks.that(false, "ghosts are chosen anew");
    if (k % 1000 != 0 && k + 1 < selections) continue;
    const hg_pair *pairs = nullptr;
    size_t pair_count = 0;
    need(hg_mpi_query_pairs(world.get(), &pairs, &pair_count));
    checks.that(sum_of(static_cast<int64_t>(pair_count)) == count, "a pair for each sphere of the ring");
  }
  const int64_t most = sum_of(static_cast<int64_t>(gids.size()) + world.stats().ghost_count);
  if (ranks.is_first()) {
    std::printf("%lld choices among %lld particles and ghosts\n", static_cast<long long>(world.stats().selection_count),
                static_cast<long long>(most));
  }
  return checks.conclude();
}

}  // namespace

int main(int argc, char **argv) {
  const int64_t selections = argc > 1 ? std::strtoll(argv[1], nullptr, 10) : 1000000;
  const int64_t count = argc > 2 ? std::strtoll(argv[2], nullptr, 10) : 2200;
  return on_ranks(argc, argv, [&](const Ranks &ranks) { return choose_again(ranks, selections, count); });
}
