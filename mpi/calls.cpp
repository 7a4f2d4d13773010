// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The functions of hgrid/mpi.h: no exception leaves, every failure has a status and a text.
#include "mpi/world.hpp"

#include <cstring>
#include <memory>
#include <new>

using hgrid::mpi::check;
using hgrid::mpi::check_mpi;
using hgrid::mpi::check_pointer;
using hgrid::mpi::fail;
using hgrid::mpi::outcome_of;
using hgrid::mpi::together;
using hgrid::mpi::World;

struct hg_mpi {
  hg_mpi(MPI_Comm comm, const hg_grid_def &grid_def, const hg_mpi_def &def) : world(comm, grid_def, def) {}
  World world;
};

namespace {

template <class Body>
hg_status guarded(Body &&body) noexcept {
  const hgrid::mpi::Outcome outcome = outcome_of(body);
  if (outcome.status != HG_OK) hg_set_last_error(outcome.text);
  return outcome.status;
}

// A NULL object has no communicator on which the ranks could agree: that failure stays with the rank that made it.
template <class Body>
hg_status on_world(hg_mpi *mpi, Body &&body) noexcept {
  return guarded([&] {
    check_pointer(mpi, "mpi");
    body(mpi->world);
  });
}

// Local calls, which look at what a successful hg_mpi_set has left.
template <class Body>
hg_status look_at(hg_mpi *mpi, Body &&body) noexcept {
  return on_world(mpi, [&](World &world) {
    world.check_usable();
    body(world);
  });
}

void check_initialized() {
  int initialized = 0, finalized = 0;
  MPI_Initialized(&initialized);
  MPI_Finalized(&finalized);
  if (initialized == 0) fail(HG_ERR_STATE, "MPI is not initialised: call MPI_Init first");
  if (finalized != 0) fail(HG_ERR_STATE, "MPI is finalised already");
}

void check_comm(MPI_Comm comm) {
  if (comm == MPI_COMM_NULL) fail(HG_ERR_ARGUMENT, "comm is MPI_COMM_NULL");
  int joins = 0;
  check_mpi(MPI_Comm_test_inter(comm, &joins), "MPI_Comm_test_inter");
  if (joins != 0) fail(HG_ERR_ARGUMENT, "comm joins two groups of ranks");
}

hg_mpi_def checked(const hg_mpi_def *given) {
  hg_mpi_def def;
  check(hg_mpi_def_init(&def, sizeof def));
  if (given == nullptr) return def;
  if (given->struct_size == 0 || given->struct_size > sizeof def) {
    fail(HG_ERR_ARGUMENT, "def.struct_size is %u: call hg_mpi_def_init first", given->struct_size);
  }
  std::memcpy(&def, given, given->struct_size);
  if (def.balancer != HG_MPI_BISECTION && def.balancer != HG_MPI_CURVE) {
    fail(HG_ERR_ARGUMENT, "def.balancer is %d", static_cast<int>(def.balancer));
  }
  if (def.verify != 0 && def.verify != 1) fail(HG_ERR_ARGUMENT, "def.verify is %d", static_cast<int>(def.verify));
  if (def.reserved0 != 0) fail(HG_ERR_ARGUMENT, "def.reserved0 is %d, not 0", static_cast<int>(def.reserved0));
  if (!(def.imbalance >= 1 && def.imbalance < 1e6)) fail(HG_ERR_ARGUMENT, "def.imbalance is %g", def.imbalance);
  return def;
}

// What the core makes of a definition, read by its own struct_size; refused as hg_create refuses it.
hg_grid_def checked(const hg_grid_def *given) {
  hg_grid_def def = hg_default_grid_def();
  if (given == nullptr) return def;
  (void)hgrid::mpi::make_grid(*given);
  std::memcpy(&def, given, given->struct_size < sizeof def ? given->struct_size : sizeof def);
  def.struct_size = sizeof def;
  if (def.images != HG_NEAREST_IMAGE) fail(HG_ERR_ARGUMENT, "images is %d, not HG_NEAREST_IMAGE", def.images);
  return def;
}

// A number that differs if members do that all ranks must have alike (FNV-1a).
int64_t fingerprint(const hg_grid_def &grid_def, const hg_mpi_def &def) {
  uint64_t hash = 14695981039346656037U;
  const auto add = [&](const auto &member) {
    unsigned char bytes[sizeof member];
    std::memcpy(bytes, &member, sizeof member);
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 1099511628211U;
  };
  add(grid_def.dimension);
  add(grid_def.interaction);
  add(grid_def.accuracy);
  add(grid_def.margin);
  add(grid_def.skin);
  add(grid_def.periodic);
  for (int axis = 0; axis < 3; axis++) {
    if (grid_def.periodic[axis] == 0) continue;
    add(grid_def.box_min[axis]);
    add(grid_def.box_max[axis]);
  }
  add(grid_def.tilt);
  add(grid_def.touching);
  add(def.balancer);
  add(def.verify);
  add(def.imbalance);
  return static_cast<int64_t>(hash >> 1);
}

MPI_Comm duplicate_of(MPI_Comm comm) {
  MPI_Comm copy = MPI_COMM_NULL;
  check_mpi(MPI_Comm_dup(comm, &copy), "MPI_Comm_dup");
  check_mpi(MPI_Comm_set_errhandler(copy, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
  return copy;
}

}  // namespace

hg_status hg_mpi_def_init(hg_mpi_def *def, size_t struct_size) {
  return guarded([&] {
    check_pointer(def, "def");
    if (struct_size == 0 || struct_size > sizeof(hg_mpi_def)) {
      fail(HG_ERR_ARGUMENT, "struct_size is %zu, this library's is %zu", struct_size, sizeof(hg_mpi_def));
    }
    const hg_mpi_def defaults{static_cast<uint32_t>(struct_size), HG_MPI_BISECTION, 0, 0, 1.05};
    std::memcpy(def, &defaults, struct_size);
  });
}

hg_status hg_mpi_create(MPI_Comm comm, const hg_grid_def *grid_def, const hg_mpi_def *def, hg_mpi **mpi) {
  if (mpi != nullptr) *mpi = nullptr;
  return guarded([&] {
    check_initialized();
    check_comm(comm);
    MPI_Comm copy = duplicate_of(comm);
    hg_grid_def checked_grid_def = hg_default_grid_def();
    hg_mpi_def checked_def{};
    std::unique_ptr<hg_mpi> made;
    try {
      together(copy, [&] {
        check_pointer(mpi, "mpi");
        checked_grid_def = checked(grid_def);
        checked_def = checked(def);
      });
      hgrid::mpi::together_of(copy, fingerprint(checked_grid_def, checked_def), "what the definitions say", [] {});
      // The object frees the communicator from here on, unless it could not be made.
      const hgrid::mpi::Outcome outcome =
          outcome_of([&] { made = std::make_unique<hg_mpi>(copy, checked_grid_def, checked_def); });
      hgrid::mpi::agree(copy, outcome);
    } catch (...) {
      if (made == nullptr) MPI_Comm_free(&copy);
      throw;
    }
    *mpi = made.release();
  });
}

hg_status hg_mpi_create_f(int32_t fortran_comm, const hg_grid_def *grid_def, const hg_mpi_def *def, hg_mpi **mpi) {
  if (mpi != nullptr) *mpi = nullptr;
  // A handle can be turned only while MPI is there.
  const hg_status status = guarded(check_initialized);
  return status != HG_OK ? status : hg_mpi_create(MPI_Comm_f2c(fortran_comm), grid_def, def, mpi);
}

hg_status hg_mpi_destroy(hg_mpi *mpi) {
  return guarded([&] {
    if (mpi == nullptr) return;
    if (mpi->world.is_visited()) fail(HG_ERR_STATE, "the pairs are being visited: the object is not destroyed");
    delete mpi;
  });
}

hg_status hg_mpi_set(hg_mpi *mpi, size_t count, const int64_t *gids, const double *centers, const double *radii) {
  return on_world(mpi, [&](World &world) { world.set(count, gids, centers, radii); });
}

hg_status hg_mpi_balance(hg_mpi *mpi, const double *weights, size_t *new_count) {
  return on_world(mpi, [&](World &world) {
    world.balance(weights);
    if (new_count != nullptr) *new_count = world.owned_count();
  });
}

hg_status hg_mpi_owned(hg_mpi *mpi, size_t *count, const int64_t **gids, const double **centers, const double **radii) {
  return look_at(mpi, [&](World &world) {
    if (count != nullptr) *count = world.owned_count();
    if (gids != nullptr) *gids = world.particles().gids.data();
    if (centers != nullptr) *centers = world.particles().centers.data();
    if (radii != nullptr) *radii = world.particles().radii.data();
  });
}

hg_status hg_mpi_migrate(hg_mpi *mpi, size_t row_bytes, const void *before, void *after) {
  return on_world(mpi, [&](World &world) { world.migrate(row_bytes, before, after); });
}

hg_status hg_mpi_move(hg_mpi *mpi, size_t count, const double *centers, const double *radii, int32_t *ghosts_changed) {
  return on_world(mpi, [&](World &world) {
    const bool changed = world.move(count, centers, radii);
    if (ghosts_changed != nullptr) *ghosts_changed = changed ? 1 : 0;
  });
}

hg_status hg_mpi_set_groups(hg_mpi *mpi, size_t count, const int32_t *groups) {
  return on_world(mpi, [&](World &world) { world.set_groups(count, groups); });
}

hg_status hg_mpi_set_group_pair(hg_mpi *mpi, int32_t group_a, int32_t group_b, int32_t interacts) {
  return on_world(mpi, [&](World &world) { world.set_group_pair(group_a, group_b, interacts); });
}

hg_status hg_mpi_set_bodies(hg_mpi *mpi, size_t count, const int32_t *bodies) {
  return on_world(mpi, [&](World &world) { world.set_bodies(count, bodies); });
}

hg_status hg_mpi_query_pairs(hg_mpi *mpi, const hg_pair **pairs, size_t *count) {
  return look_at(mpi, [&](World &world) {
    check_pointer(pairs, "pairs");
    check_pointer(count, "count");
    const std::vector<hg_pair> &found = world.search().pairs();
    *pairs = found.empty() ? nullptr : found.data();
    *count = found.size();
  });
}

hg_status hg_mpi_visit_pairs(hg_mpi *mpi, hg_pair_visitor *visit, void *context) {
  return look_at(mpi, [&](World &world) {
    if (visit == nullptr) fail(HG_ERR_NULL, "visit is NULL");
    world.search().visit(visit, context);
  });
}

hg_status hg_mpi_ghosts(hg_mpi *mpi, size_t *count, const int64_t **gids, const int32_t **owners,
                        const double **centers, const double **radii) {
  return look_at(mpi, [&](World &world) {
    const hgrid::mpi::Particles &all = world.particles();
    const size_t first = world.owned_count();
    if (count != nullptr) *count = all.count() - first;
    if (gids != nullptr) *gids = all.gids.data() + first;
    if (owners != nullptr) *owners = world.ghost_owners().data();
    if (centers != nullptr) *centers = all.centers.data() + first * all.dimension;
    if (radii != nullptr) *radii = all.radii.data() + first;
  });
}

hg_status hg_mpi_forward(hg_mpi *mpi, size_t row_bytes, const void *owned, void *ghosts) {
  return on_world(mpi, [&](World &world) { world.forward(row_bytes, owned, ghosts); });
}

hg_status hg_mpi_reverse_add(hg_mpi *mpi, size_t columns, const double *ghosts, double *owned) {
  return on_world(mpi, [&](World &world) { world.add_back(columns, ghosts, owned); });
}

hg_status hg_mpi_get_stats(hg_mpi *mpi, hg_mpi_stats *stats, size_t struct_size) {
  return on_world(mpi, [&](World &world) {
    check_pointer(stats, "stats");
    if (struct_size == 0 || struct_size > sizeof(hg_mpi_stats)) {
      fail(HG_ERR_ARGUMENT, "struct_size is %zu, this library's is %zu", struct_size, sizeof(hg_mpi_stats));
    }
    const hg_mpi_stats all = world.stats();
    std::memcpy(stats, &all, struct_size);
  });
}
