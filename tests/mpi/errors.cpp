// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What goes wrong on one rank: all ranks return, none waits, the text names the rank, and the object can still be used.
#include "tests/mpi/ranks.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>

namespace {

using namespace hgtest::mpi;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Case {
  const Ranks &ranks;
  Checks &checks;
  int culprit;  // the rank that does something wrong

  bool guilty() const { return ranks.rank() == culprit; }
  void all_fail(hg_status got, hg_status own, const char *what, const char *word) const {
    checks.status(got, guilty() ? own : hg_status{HG_ERR_REMOTE}, what);
    names_rank(what, word);
  }
  void names_rank(const char *what, const char *word) const {
    const std::string text = hg_last_error(), name = "rank " + std::to_string(culprit) + ": ";
    const bool named = text.rfind(name, 0) == 0 && text.find(word) != std::string::npos;
    if (!named) checks.that(false, (std::string(what) + " says: " + text).c_str());
  }
};

// Two particles for each rank, far from others.
struct Own {
  std::vector<int64_t> gids;
  std::vector<double> centers, radii = {0.1, 0.1};
  explicit Own(const Ranks &ranks) {
    for (int k = 0; k < 2; k++) {
      gids.push_back(10 * ranks.rank() + k);
      centers.insert(centers.end(), {static_cast<double>(ranks.rank()), 0.15 * k, 0.0});
    }
  }
  hg_status set(const World &world) const {
    return hg_mpi_set(world.get(), 2, gids.data(), centers.data(), radii.data());
  }
};

int64_t count_pairs(const World &world) {
  const hg_pair *pairs = nullptr;
  size_t count = 0;
  need(hg_mpi_query_pairs(world.get(), &pairs, &count));
  return sum_of(static_cast<int64_t>(count));
}

void arguments(const Case &is) {
  const World world(hg_default_grid_def());
  const Own good(is.ranks);
  const hg_pair *pairs = nullptr;
  size_t count = 0;
  is.checks.status(hg_mpi_query_pairs(world.get(), &pairs, &count), HG_ERR_STATE, "pairs before set");
  is.checks.status(hg_mpi_move(world.get(), 0, nullptr, nullptr, nullptr), HG_ERR_STATE, "move before set");
  is.checks.status(hg_mpi_balance(world.get(), nullptr, nullptr), HG_ERR_STATE, "balance before set");
  need(good.set(world));
  is.checks.status(hg_mpi_migrate(world.get(), 0, nullptr, nullptr), HG_ERR_STATE, "migrate before balance");
  const int64_t before = count_pairs(world);
  is.checks.that(before == is.ranks.size(), "a pair on each rank");

  Own bad = good;
  if (is.guilty()) bad.centers[4] = kNan;
  is.all_fail(bad.set(world), HG_ERR_ARGUMENT, "a NaN", "centers[1][1] is nan");
  is.all_fail(hg_mpi_move(world.get(), 2, bad.centers.data(), nullptr, nullptr), HG_ERR_ARGUMENT, "a NaN moved",
              "centers[1][1] is nan");
  bad = good;
  if (is.guilty()) bad.radii[0] = -1;
  is.all_fail(bad.set(world), HG_ERR_ARGUMENT, "a negative radius", "radii[0] is -1");
  is.all_fail(hg_mpi_move(world.get(), is.guilty() ? 1 : 2, good.centers.data(), nullptr, nullptr), HG_ERR_ARGUMENT,
              "a wrong count", "owns 2");
  is.all_fail(
      hg_mpi_set(world.get(), 2, is.guilty() ? nullptr : good.gids.data(), good.centers.data(), good.radii.data()),
      HG_ERR_NULL, "no gids", "gids is NULL");
  const int32_t groups[2] = {0, is.guilty() ? 32 : 1};
  is.all_fail(hg_mpi_set_groups(world.get(), 2, groups), HG_ERR_ARGUMENT, "a group", "groups[1] is 32");
  const int32_t bodies[2] = {0, is.guilty() ? -2 : 1};
  is.all_fail(hg_mpi_set_bodies(world.get(), 2, bodies), HG_ERR_ARGUMENT, "a body", "bodies[1] is -2");
  const double weights[2] = {1, is.guilty() ? -1.0 : 1.0};
  is.all_fail(hg_mpi_balance(world.get(), weights, nullptr), HG_ERR_ARGUMENT, "a weight", "weights[1] is -1");
  is.checks.that(count_pairs(world) == before, "refused calls change nothing");

  const double row[2] = {0, 0};
  double ghost[2] = {0, 0};
  if (is.ranks.size() > 1) {
    is.checks.status(hg_mpi_forward(world.get(), is.guilty() ? 4 : 8, row, ghost), HG_ERR_ARGUMENT, "rows differ");
    const double ones[2] = {1, 1};
    is.checks.status(hg_mpi_balance(world.get(), is.guilty() ? ones : nullptr, nullptr), HG_ERR_ARGUMENT,
                     "weights on one rank only");
  }
}

void short_box(const Case &is) {
  hg_grid_def def = hg_default_grid_def();
  for (int axis = 0; axis < 3; axis++) {
    def.periodic[axis] = 1;
    def.box_max[axis] = is.ranks.size();
  }
  const World world(def);
  const Own good(is.ranks);
  need(good.set(world));
  // One giant alone fits, two on different ranks do not: only all ranks together can tell.
  Own one = good;
  if (is.guilty()) one.radii[0] = 0.35 * is.ranks.size();
  const double second = 0.2 * is.ranks.size();
  is.checks.status(one.set(world), HG_OK, "one giant");
  Own two = one;
  if (is.ranks.rank() == (is.culprit + 1) % is.ranks.size()) two.radii[1] = second;
  const hg_status status = two.set(world);
  is.checks.status(status, HG_ERR_ARGUMENT, "two giants on two ranks");
  need(good.set(world));
  is.checks.status(hg_mpi_move(world.get(), 2, two.centers.data(), two.radii.data(), nullptr), HG_ERR_ARGUMENT,
                   "two giants grow");
  is.checks.that(count_pairs(world) == is.ranks.size(), "nothing has changed");
}

void gids(const Case &is) {
  hg_mpi_def def;
  need(hg_mpi_def_init(&def, sizeof def));
  def.verify = 1;
  const World world(hg_default_grid_def(), MPI_COMM_WORLD, &def);
  Own own(is.ranks);
  need(own.set(world));
  if (is.guilty()) own.gids[1] = int64_t{10} * ((is.culprit + 1) % is.ranks.size());
  const hg_status status = own.set(world);
  is.checks.that(status == HG_ERR_ARGUMENT || status == HG_ERR_REMOTE, "a gid that stands twice");
  is.checks.that(std::strstr(hg_last_error(), "stands twice") != nullptr, "the text says which");
}

// Memory of the grid of one rank that runs out at the n-th request.
struct Budget {
  long left;
};
void *allocate(void *context, size_t size) {
  return --static_cast<Budget *>(context)->left < 0 ? nullptr : std::malloc(size);
}
void *reallocate(void *context, void *memory, size_t, size_t size) {
  return --static_cast<Budget *>(context)->left < 0 ? nullptr : std::realloc(memory, size);
}
void release(void *, void *memory, size_t) { std::free(memory); }

void memory(const Case &is) {
  bool refused = false;
  for (long left = 0; left < 200; left += 3) {
    Budget budget{is.guilty() ? left : 1000000};
    const hg_allocator allocator{&budget, allocate, reallocate, release};
    need(hg_set_allocator(&allocator));
    hg_mpi *mpi = nullptr;
    hg_status status = hg_mpi_create(MPI_COMM_WORLD, nullptr, nullptr, &mpi);
    if (status == HG_OK) {
      const Own own(is.ranks);
      status = hg_mpi_set(mpi, 2, own.gids.data(), own.centers.data(), own.radii.data());
      budget.left = 1000000;
      if (status != HG_OK) {
        is.all_fail(status, HG_ERR_MEMORY, "no memory for set", "no memory");
        const hg_status empty = hg_mpi_move(mpi, 2, own.centers.data(), nullptr, nullptr);
        is.checks.that(empty == HG_ERR_STATE || empty == HG_ERR_REMOTE, "no particles are left");
        status = hg_mpi_set(mpi, 2, own.gids.data(), own.centers.data(), own.radii.data());
        is.checks.status(status, HG_OK, "set after no memory");
        refused = true;
      }
      need(hg_mpi_destroy(mpi));
    } else {
      is.all_fail(status, HG_ERR_MEMORY, "no memory for create", "no memory");
      is.checks.that(mpi == nullptr, "*mpi is NULL");
    }
    need(hg_set_allocator(nullptr));
  }
  is.checks.that(refused, "some budget is enough to create the object, but not to fill it");
}

void limits(const Case &is) {
  // Its owner refuses it, whoever would have it as a ghost.
  hg_grid_def def = hg_default_grid_def();
  def.periodic[0] = 1;
  def.box_max[0] = 10;
  const World world(def);
  Own own(is.ranks);
  if (is.guilty()) own.centers[0] = 1e9;
  is.all_fail(own.set(world), HG_ERR_LIMIT, "far outside", "box");
  is.checks.status(Own(is.ranks).set(world), HG_OK, "set anew");
  is.all_fail(hg_mpi_move(world.get(), 2, own.centers.data(), nullptr, nullptr), HG_ERR_LIMIT, "moved far outside",
              "box");
  is.checks.that(count_pairs(world) == is.ranks.size(), "nothing has moved");
}

void definitions(const Case &is) {
  hg_mpi *mpi = nullptr;
  hg_grid_def def = hg_default_grid_def();
  if (is.guilty()) def.margin = -1;
  is.all_fail(hg_mpi_create(MPI_COMM_WORLD, &def, nullptr, &mpi), HG_ERR_ARGUMENT, "a margin", "margin");
  def.margin = is.guilty() ? 0.25 : 0;
  const hg_status status = hg_mpi_create(MPI_COMM_WORLD, &def, nullptr, &mpi);
  is.checks.status(status, is.ranks.size() > 1 ? HG_ERR_ARGUMENT : HG_OK, "margins differ");
  if (status == HG_OK) need(hg_mpi_destroy(mpi));
  def = hg_default_grid_def();
  def.images = HG_ALL_IMAGES;
  is.checks.status(hg_mpi_create(MPI_COMM_WORLD, &def, nullptr, &mpi), HG_ERR_ARGUMENT, "all images");
  is.all_fail(hg_mpi_create(MPI_COMM_WORLD, nullptr, nullptr, is.guilty() ? nullptr : &mpi), HG_ERR_NULL, "no result",
              "mpi is NULL");
  is.checks.status(hg_mpi_create(MPI_COMM_NULL, nullptr, nullptr, &mpi), HG_ERR_ARGUMENT, "no communicator");
  is.checks.status(hg_mpi_destroy(nullptr), HG_OK, "nothing to destroy");
  is.checks.status(hg_mpi_move(nullptr, 0, nullptr, nullptr, nullptr), HG_ERR_NULL, "no object");
  hg_mpi_def mpi_def;
  is.checks.status(hg_mpi_def_init(nullptr, sizeof mpi_def), HG_ERR_NULL, "no definition");
  is.checks.status(hg_mpi_def_init(&mpi_def, sizeof mpi_def + 8), HG_ERR_ARGUMENT, "a header newer than the library");
  need(hg_mpi_def_init(&mpi_def, sizeof mpi_def));
  if (is.guilty()) mpi_def.imbalance = 0.5;
  is.all_fail(hg_mpi_create(MPI_COMM_WORLD, nullptr, &mpi_def, &mpi), HG_ERR_ARGUMENT, "imbalance", "imbalance");
  is.checks.that(std::string(hg_status_string(HG_ERR_REMOTE)) == "HG_ERR_REMOTE", "the name of a status");
}

}  // namespace

int main(int argc, char **argv) {
  hg_mpi *early = nullptr, *late = nullptr;
  const bool refused = hg_mpi_create(MPI_COMM_WORLD, nullptr, nullptr, &early) == HG_ERR_STATE;
  int result = on_ranks(argc, argv, [&](const Ranks &ranks) {
    Checks checks;
    checks.that(refused, "create before MPI_Init is refused");
    for (int culprit = 0; culprit < ranks.size(); culprit += 2) {
      const Case is{ranks, checks, culprit};
      arguments(is);
      if (ranks.size() > 1) short_box(is);
      if (ranks.size() > 1) gids(is);
      memory(is);
      limits(is);
      definitions(is);
    }
    checks.status(hg_mpi_create(MPI_COMM_WORLD, nullptr, nullptr, &late), HG_OK, "create");
    return checks.conclude();
  });
  // After MPI_Finalize only memory is left to free.
  if (hg_mpi_destroy(late) != HG_OK) result = 1;
  if (hg_mpi_create(MPI_COMM_WORLD, nullptr, nullptr, &late) != HG_ERR_STATE) result = 1;
  return result;
}
