// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What the calls promise beside the pairs: which ghosts there are, when they change, what rows do, several objects.
#include "tests/mpi/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace {

using namespace hgtest::mpi;
using hgtest::Rng;

// As Fortran knows them (use_f08.f90).
static_assert(sizeof(hg_mpi_def) == 24 && offsetof(hg_mpi_def, imbalance) == 16);
static_assert(sizeof(hg_mpi_stats) == 80 && offsetof(hg_mpi_stats, imbalance) == 72);

// Spheres of ratio 10 in a periodic cube, dealt out in slabs or at random.
Scene crowd(const Ranks &ranks, size_t count, bool slabs) {
  Rng rng(11);
  Scene scene;
  scene.def.thread_count = 1;
  for (int axis = 0; axis < 3; axis++) {
    scene.def.periodic[axis] = 1;
    scene.def.box_max[axis] = 1;
  }
  for (size_t k = 0; k < count; k++) {
    scene.add({rng.uniform(), rng.uniform(), rng.uniform()}, 0.06 / std::pow(10.0, rng.uniform()));
    scene.gids.push_back(static_cast<int64_t>(k) * 7 + (int64_t{1} << 45));
    const int slab = static_cast<int>(scene.centers[3 * k] * ranks.size());
    scene.owners.push_back(slabs ? slab : rng.integer(0, ranks.size() - 1));
  }
  scene.groups.assign(count, 0);
  scene.bodies.assign(count, -1);
  return scene;
}

void small_ones_stay(const Ranks &ranks, Checks &checks) {
  // Rank 0 has two giants, another rank a hundred small ones around one of them, all within the box of the giants'
  // centres: that giant travels, nobody else.
  Scene scene;
  scene.add({10, 10, 10}, 10.0);
  scene.add({-10, -10, -10}, 10.0);
  scene.owners = {0, 0};
  for (int k = 0; k < 100; k++) {
    scene.add({10 - std::cos(0.0157 * k) * 10.05, 10 - std::sin(0.0157 * k) * 10.05, 10.0}, 0.1);
    scene.owners.push_back(ranks.size() - 1);
  }
  for (size_t k = 0; k < scene.count(); k++) scene.gids.push_back(static_cast<int64_t>(k));
  scene.groups.assign(scene.count(), 0);
  scene.bodies.assign(scene.count(), -1);
  const World world(scene.def);
  hand_out(scene, world);
  checks.that(sum_of(world.stats().ghost_count) == (ranks.size() > 1 ? 1 : 0), "one giant is the only ghost");
  checks.that(wrong_pairs(scene, world, &checks, nullptr) == 0, "giants and small ones");
}

void ghosts_change_seldom(const Ranks &ranks, Checks &checks) {
  Scene scene = crowd(ranks, 300, true);
  scene.def.skin = 0.05;
  const World world(scene.def);
  hand_out(scene, world);
  Rng rng(5);
  int changes = 0;
  for (int step = 0; step < 12; step++) {
    for (double &x : scene.centers) x += rng.uniform(-0.004, 0.004);
    changes += move_all(scene, world, false) ? 1 : 0;
    checks.that(wrong_pairs(scene, world, &checks, nullptr) == 0, "pairs in each step");
  }
  checks.that(changes > 0 && changes < 6, "ghosts are chosen now and then only");
  // A user who wraps moves nobody.
  const bool wrapped_before = move_all(scene, world, false);
  for (double &x : scene.centers) x += x < 0 ? 1.0 : x >= 1 ? -1.0 : 0.0;
  checks.that(!wrapped_before && !move_all(scene, world, false), "wrapping is no motion");
  checks.that(wrong_pairs(scene, world, &checks, nullptr) == 0, "pairs of wrapped particles");
  // One fast particle, which one rank owns, concerns all.
  scene.centers[0] += 0.3;
  checks.that(move_all(scene, world, false), "all ranks choose anew");
  checks.that(wrong_pairs(scene, world, &checks, nullptr) == 0, "pairs of a fast one");
  const hg_mpi_stats stats = world.stats();
  checks.that(stats.selection_count == changes + 2 && stats.selection_count + stats.update_count == 16, "counters");
}

// Forces that depend on the pair alone: f on a, -f on b.
std::vector<double> forces_of(const World &world, Checks &checks) {
  const std::vector<int64_t> gids = world.all_gids();
  const auto owned = static_cast<size_t>(world.stats().owned_count);
  std::vector<double> forces(gids.size() * 3);
  const hg_pair *pairs = nullptr;
  size_t count = 0;
  need(hg_mpi_query_pairs(world.get(), &pairs, &count));
  for (size_t k = 0; k < count; k++) {
    const auto a = static_cast<size_t>(pairs[k].a), b = static_cast<size_t>(pairs[k].b);
    for (size_t axis = 0; axis < 3; axis++) {
      const double f = std::sin(static_cast<double>((gids[a] ^ gids[b]) % 1000) + static_cast<double>(axis));
      forces[a * 3 + axis] += f;
      forces[b * 3 + axis] -= f;
    }
  }
  std::vector<double> own(forces.begin(), forces.begin() + static_cast<ptrdiff_t>(owned * 3));
  checks.status(hg_mpi_reverse_add(world.get(), 3, forces.data() + owned * 3, own.data()), HG_OK, "reverse_add");
  return own;
}

void forces_return(const Ranks &ranks, Checks &checks) {
  const Scene scene = crowd(ranks, 400, false);
  const World one(scene.def), two(scene.def);
  hand_out(scene, one);
  hand_out(scene, two);
  const std::vector<double> forces = forces_of(one, checks);
  checks.that(forces == forces_of(two, checks), "two objects give the same bits");
  double sum[3] = {0, 0, 0}, all[3] = {0, 0, 0};
  for (size_t k = 0; k < forces.size(); k++) sum[k % 3] += forces[k];
  MPI_Allreduce(sum, all, 3, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  for (const double component : all) checks.that(std::fabs(component) < 1e-9, "momentum is conserved");
  // Rows of any size go out with the owner's bits.
  struct Row {
    int64_t gid;
    char letters[5];
  };
  std::vector<Row> own;
  const std::vector<int64_t> gids = one.all_gids();
  const auto owned = static_cast<size_t>(one.stats().owned_count);
  for (size_t k = 0; k < owned; k++) own.push_back({gids[k], {'a', 'b', 'c', 'd', 'e'}});
  std::vector<Row> ghosts(gids.size() - owned);
  need(hg_mpi_forward(one.get(), sizeof(Row), own.data(), ghosts.data()));
  for (size_t k = 0; k < ghosts.size(); k++) {
    checks.that(ghosts[k].gid == gids[owned + k] && ghosts[k].letters[4] == 'e', "rows forwarded");
  }
}

// Springs of contacts, keyed by gids, grow by what they were in each step; new owners in between.
void springs_survive(const Ranks &ranks, Checks &checks) {
  Scene scene = crowd(ranks, 300, false);
  const World world(scene.def);
  hand_out(scene, world);
  std::map<GidPair, double> springs, truth;
  Rng rng(3);
  for (int step = 0; step < 6; step++) {
    for (double &x : scene.centers) x += rng.uniform(-0.01, 0.01);
    (void)move_all(scene, world, false);
    const auto advance = [](const std::vector<GidPair> &pairs, std::map<GidPair, double> &state) {
      std::map<GidPair, double> next;
      for (const GidPair &pair : pairs) {
        const auto old = state.find(pair);
        next[pair] = (old == state.end() ? 0.0 : old->second * 1.1) + static_cast<double>(pair.first % 97) * 0.3;
      }
      state = next;
    };
    advance(found_pairs(world, 0, &checks), springs);
    if (ranks.is_first()) {
      advance(true_pairs(scene), truth);
      checks.that(springs == truth, "springs are those of one rank, bit by bit");
    }
    if (step != 2) continue;
    const hg_status status = hg_mpi_balance(world.get(), nullptr, nullptr);
    checks.that(status == HG_OK || status == HG_ERR_STATE, "balance, or no Zoltan");
  }
}

// The history of the library with keys of 64 bits follows contacts whose local ids change.
void history_by_gids(const Ranks &ranks, Checks &checks) {
  const Scene scene = crowd(ranks, 200, false);
  const World world(scene.def);
  hand_out(scene, world);
  hg_history *history = nullptr;
  need(hg_history_create(&history));
  for (int round = 0; round < 2; round++) {
    const std::vector<int64_t> gids = world.all_gids();
    const hg_pair *pairs = nullptr;
    size_t count = 0;
    need(hg_mpi_query_pairs(world.get(), &pairs, &count));
    std::vector<hg_contact_key> keys;
    for (size_t k = 0; k < count; k++) {
      const GidPair pair = std::minmax(gids[static_cast<size_t>(pairs[k].a)], gids[static_cast<size_t>(pairs[k].b)]);
      keys.push_back({pair.first, pair.second, 0});
    }
    const int64_t *previous = nullptr;
    need(hg_history_update_keys(history, count, keys.data(), &previous));
    for (size_t k = 0; k < count && round == 1; k++) checks.that(previous[k] >= 0, "each contact was there");
    hand_out(scene, world);
  }
  hg_history_destroy(history);
}

struct Seen {
  std::vector<hg_pair> pairs;
  hg_mpi *mpi;
  hg_status inside;
};

int32_t see(void *context, const hg_pair *pairs, size_t count) {
  auto *seen = static_cast<Seen *>(context);
  seen->pairs.insert(seen->pairs.end(), pairs, pairs + count);
  const hg_pair *none = nullptr;
  size_t zero = 0;
  seen->inside = hg_mpi_query_pairs(seen->mpi, &none, &zero);
  return 0;
}

int32_t stop(void *context, const hg_pair *, size_t) {
  ++*static_cast<int *>(context);
  return 1;
}

void visits(const Ranks &ranks, Checks &checks) {
  Scene scene = crowd(ranks, 2000, false);
  const World world(scene.def);
  hand_out(scene, world);
  Seen seen{{}, world.get(), HG_ERR_STATE};
  need(hg_mpi_visit_pairs(world.get(), see, &seen));
  checks.status(seen.inside, HG_ERR_STATE, "a call from a visitor");
  const hg_pair *pairs = nullptr;
  size_t count = 0;
  need(hg_mpi_query_pairs(world.get(), &pairs, &count));
  checks.that(count > 100 && count == seen.pairs.size(), "as many pairs are visited as there are");
  checks.that(std::equal(pairs, pairs + count, seen.pairs.begin(),
                         [](const hg_pair &p, const hg_pair &q) { return p.a == q.a && p.b == q.b; }),
              "the pairs visited");
  checks.that(world.stats().pair_count == static_cast<int64_t>(count), "pair_count");
  int calls = 0;
  need(hg_mpi_visit_pairs(world.get(), stop, &calls));
  checks.that(calls == 1, "a visit can be stopped");
}

void parts_of_a_communicator(const Ranks &ranks, Checks &checks) {
  MPI_Comm half = MPI_COMM_NULL;
  MPI_Comm_split(MPI_COMM_WORLD, ranks.rank() % 2, ranks.rank(), &half);
  {
    hg_mpi *mpi = nullptr;
    const int64_t gid = ranks.rank();
    const double center[3] = {0, 0, 0}, radius = 1;
    need(hg_mpi_create_f(MPI_Comm_c2f(half), nullptr, nullptr, &mpi));
    need(hg_mpi_set(mpi, 1, &gid, center, &radius));
    size_t ghosts = 0, count = 0;
    const int32_t *owners = nullptr;
    const hg_pair *pairs = nullptr;
    need(hg_mpi_ghosts(mpi, &ghosts, nullptr, &owners, nullptr, nullptr));
    need(hg_mpi_query_pairs(mpi, &pairs, &count));
    int size = 1, rank = 0;
    MPI_Comm_size(half, &size);
    MPI_Comm_rank(half, &rank);
    // Equal radii: a particle is a ghost where smaller gids are, and these find the pair.
    checks.that(count == static_cast<size_t>(size - 1 - rank), "all meet on the ranks of a part");
    checks.that(ghosts == static_cast<size_t>(size - 1) && (ghosts == 0 || owners[0] < size), "ghosts of a part");
    need(hg_mpi_destroy(mpi));
  }
  MPI_Comm_free(&half);
}

// Choosing ghosts again and again uses nothing up.
void many_choices(const Ranks &ranks, Checks &checks) {
  Scene scene = crowd(ranks, 60, false);
  const World world(scene.def);
  hand_out(scene, world);
  const std::vector<double> here = owned_part(scene, world, scene.centers, 3);
  for (double &x : scene.centers) x += 0.25;
  const std::vector<double> there = owned_part(scene, world, scene.centers, 3);
  for (int k = 0; k < 200; k++) {
    need(hg_mpi_move(world.get(), here.size() / 3, (k % 2 == 0 ? here : there).data(), nullptr, nullptr));
  }
  const hg_pair *pairs = nullptr;
  size_t count = 0;
  need(hg_mpi_query_pairs(world.get(), &pairs, &count));
  for (size_t k = 0; k < count; k++) {
    checks.that(pairs[k].b < static_cast<int32_t>(world.all_gids().size()), "ids start anew with each choice");
  }
}

}  // namespace

int main(int argc, char **argv) {
  return on_ranks(argc, argv, [](const Ranks &ranks) {
    Checks checks;
    small_ones_stay(ranks, checks);
    ghosts_change_seldom(ranks, checks);
    forces_return(ranks, checks);
    springs_survive(ranks, checks);
    history_by_gids(ranks, checks);
    visits(ranks, checks);
    parts_of_a_communicator(ranks, checks);
    many_choices(ranks, checks);
    return checks.conclude();
  });
}
