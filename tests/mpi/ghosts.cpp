// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_mpi_ghosts COUNT RANKS...: how many ghosts the rule needs, beside a halo of one width, 2 r_max. With one rank
// of MPI for each number of ranks given, by bisection done here; else on the ranks there are, by Zoltan. Ends with 1 if
// the rule needs more than docs/evidence/mpi.md says.
#include "mpi/size_boxes.hpp"
#include "tests/mpi/scene.hpp"
#include "tests/support/size_laws.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace {

using namespace hgtest::mpi;
using hgrid::mpi::ReachRule;
using hgrid::mpi::SizeBox;
using hgtest::Rng;

struct System {
  const char *name;
  Scene scene;
  // More ghosts per particle than that on 8 and on 64 ranks are a fault, for 125 001 particles.
  double most_of_8, most_of_64;
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
  return {{"uniform volume, ratio 50, periodic", make_scene(wide, false), 0.12, 0.26},
          {"equal sizes, periodic", make_scene(std::vector<double>(count, 1.0), false), 0.30, 0.64},
          {"uniform volume, ratio 50, 40 clouds", make_scene(wide, true), 0.08, 0.20}};
}

// Halves of equal counts, cut across the longest axis, until there are as many parts as ranks.
void bisect(Scene &scene, std::vector<size_t> rows, int first, int ranks) {
  if (ranks == 1) {
    for (const size_t row : rows) scene.owners[row] = first;
    return;
  }
  size_t longest = 0;
  double extent = -1;
  for (size_t axis = 0; axis < 3; axis++) {
    const auto [low, high] = std::minmax_element(rows.begin(), rows.end(), [&](size_t p, size_t q) {
      return scene.centers[3 * p + axis] < scene.centers[3 * q + axis];
    });
    const double here = scene.centers[3 * *high + axis] - scene.centers[3 * *low + axis];
    if (here > extent) {
      extent = here;
      longest = axis;
    }
  }
  const int left = ranks / 2;
  const auto cut = rows.begin() + static_cast<ptrdiff_t>(rows.size() * static_cast<size_t>(left) / ranks);
  std::nth_element(rows.begin(), cut, rows.end(),
                   [&](size_t p, size_t q) { return scene.centers[3 * p + longest] < scene.centers[3 * q + longest]; });
  bisect(scene, {rows.begin(), cut}, first, left);
  bisect(scene, {cut, rows.end()}, first + left, ranks - left);
}

struct Part {
  std::vector<double> centers, radii;
};

std::vector<Part> parts_of(const Scene &scene, int ranks) {
  std::vector<Part> parts(static_cast<size_t>(ranks));
  for (size_t k = 0; k < scene.count(); k++) {
    Part &part = parts[static_cast<size_t>(scene.owners[k])];
    part.centers.insert(part.centers.end(), &scene.centers[3 * k], &scene.centers[3 * k] + 3);
    part.radii.push_back(scene.radii[k]);
  }
  return parts;
}

struct Counts {
  double by_rule = 0, uniform = 0;  // per particle
};

Counts count_ghosts(const Scene &scene, int ranks) {
  const std::vector<Part> parts = parts_of(scene, ranks);
  const ReachRule rule(scene.def);
  // A halo of one width: the whole part as one class, whose particles all count as the largest.
  const double largest = *std::max_element(scene.radii.begin(), scene.radii.end());
  int64_t by_rule = 0, uniform = 0;
  for (const Part &part : parts) {
    const std::vector<SizeBox> boxes =
        make_size_boxes(rule.cell(), part.radii.size(), part.centers.data(), part.radii.data());
    const std::vector<double> all_large(part.radii.size(), largest);
    const std::vector<SizeBox> whole =
        make_size_boxes(rule.cell(), part.radii.size(), part.centers.data(), all_large.data());
    for (const Part &other : parts) {
      if (&other == &part) continue;
      for (size_t k = 0; k < other.radii.size(); k++) {
        const double *center = &other.centers[3 * k];
        const auto meets = [&](const SizeBox &box) { return rule.may_meet(box, center, other.radii[k]); };
        by_rule += std::any_of(boxes.begin(), boxes.end(), meets) ? 1 : 0;
        uniform += rule.may_meet(whole[0], center, largest) ? 1 : 0;
      }
    }
  }
  const auto count = static_cast<double>(scene.count());
  return {static_cast<double>(by_rule) / count, static_cast<double>(uniform) / count};
}

bool simulate(System &system, int ranks) {
  std::vector<size_t> rows(system.scene.count());
  for (size_t k = 0; k < rows.size(); k++) rows[k] = k;
  system.scene.owners.assign(rows.size(), 0);
  bisect(system.scene, rows, 0, ranks);
  const Counts counts = count_ghosts(system.scene, ranks);
  std::printf("| %s | %d | %.3f | %.3f |\n", system.name, ranks, counts.uniform, counts.by_rule);
  const double most = ranks <= 8 ? system.most_of_8 : ranks <= 64 ? system.most_of_64 : 1e9;
  if (counts.by_rule <= most) return true;
  std::printf("too many ghosts per particle: %.3f, at most %.3f\n", counts.by_rule, most);
  return false;
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
  for (size_t k = 0; k < system.scene.count(); k++)
    system.scene.owners.push_back(static_cast<int32_t>(k % ranks.size()));
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
  return ghosts <= system.most_of_8 && found <= 1.25;
}

}  // namespace

int main(int argc, char **argv) {
  return on_ranks(argc, argv, [&](const Ranks &ranks) {
    const size_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 125001;
    bool fits = true;
    if (ranks.is_first()) {
      std::printf(ranks.size() == 1 ? "| system | ranks | halo of 2 r_max | by size |\n|---|---|---|---|\n"
                                    : "| system | ranks | ghosts | pairs | neighbours | MB an update | pairs, largest "
                                      "over mean | found over kept |\n"
                                      "|---|---|---|---|---|---|---|---|\n");
    }
    for (System &system : systems(count)) {
      if (ranks.size() > 1) fits = measure(system, ranks) && fits;
      for (int k = 2; k < argc && ranks.size() == 1; k++) {
        fits = simulate(system, static_cast<int>(std::strtol(argv[k], nullptr, 10))) && fits;
      }
    }
    Checks checks;
    checks.that(fits, "as few ghosts as stated");
    return checks.conclude();
  });
}
