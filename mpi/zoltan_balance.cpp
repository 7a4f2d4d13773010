// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Owners by Zoltan's geometric partitioners.
#include "mpi/world.hpp"

#include <zoltan.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace hgrid::mpi {
namespace {

// What Zoltan asks for. Its global ids are a rank and a row, as its numbers have 32 bits.
struct Rows {
  int rank;
  size_t dimension;
  std::vector<double> places;  // [count][dimension], in the periodic box
  std::vector<float> weights;
};

int count_of(void *data, int *error) {
  *error = ZOLTAN_OK;
  return static_cast<int>(static_cast<const Rows *>(data)->weights.size());
}

void list_of(void *data, int, int, ZOLTAN_ID_PTR global, ZOLTAN_ID_PTR local, int, float *weights, int *error) {
  const auto *rows = static_cast<const Rows *>(data);
  for (size_t k = 0; k < rows->weights.size(); k++) {
    global[2 * k] = static_cast<ZOLTAN_ID_TYPE>(rows->rank);
    global[2 * k + 1] = static_cast<ZOLTAN_ID_TYPE>(k);
    local[k] = static_cast<ZOLTAN_ID_TYPE>(k);
    weights[k] = rows->weights[k];
  }
  *error = ZOLTAN_OK;
}

int dimension_of(void *data, int *error) {
  *error = ZOLTAN_OK;
  return static_cast<int>(static_cast<const Rows *>(data)->dimension);
}

void places_of(void *data, int, int, int count, ZOLTAN_ID_PTR, ZOLTAN_ID_PTR local, int dimension, double *places,
               int *error) {
  const auto *rows = static_cast<const Rows *>(data);
  const auto d = static_cast<size_t>(dimension);
  for (size_t k = 0; k < static_cast<size_t>(count); k++) {
    for (size_t axis = 0; axis < d; axis++) places[k * d + axis] = rows->places[local[k] * d + axis];
  }
  *error = ZOLTAN_OK;
}

struct DestroyZoltan {
  void operator()(Zoltan_Struct *zoltan) const { Zoltan_Destroy(&zoltan); }
};

void check_zoltan(int code, const char *call) {
  if (code != ZOLTAN_OK && code != ZOLTAN_WARN) fail(HG_ERR_MPI, "%s failed with code %d", call, code);
}

// The lists that Zoltan hands out, given back at the end.
struct Parts {
  int changes = 0, global_entries = 0, local_entries = 0, import_count = 0, export_count = 0;
  ZOLTAN_ID_PTR import_global = nullptr, import_local = nullptr, export_global = nullptr, export_local = nullptr;
  int *import_ranks = nullptr, *import_parts = nullptr, *export_ranks = nullptr, *export_parts = nullptr;

  Parts() = default;
  ~Parts() {
    Zoltan_LB_Free_Part(&import_global, &import_local, &import_ranks, &import_parts);
    Zoltan_LB_Free_Part(&export_global, &export_local, &export_ranks, &export_parts);
  }
  Parts(const Parts &) = delete;
  Parts &operator=(const Parts &) = delete;
};

// `most`: the largest weight of all ranks. Zoltan has floats, so weights are told as parts of it; all 0 means all
// equal.
Rows rows_of(int rank, const Cell &cell, const Particles &particles, const std::vector<double> &weights, double most) {
  const size_t count = weights.size(), d = particles.dimension;
  Rows rows{rank, d, {particles.centers.begin(), particles.centers.begin() + static_cast<ptrdiff_t>(count * d)}, {}};
  for (size_t k = 0; k < count; k++) {
    for (int axis = cell.dimension() - 1; axis >= 0; axis--) {
      double *place = &rows.places[k * d];
      if (cell.is_periodic(axis)) {
        (void)cell.shift(place, axis, -std::floor((place[axis] - cell.low(axis)) / cell.length(axis)));
      }
    }
    rows.weights.push_back(most > 0 ? static_cast<float>(weights[k] / most) : 1.0F);
  }
  return rows;
}

void set_parameters(Zoltan_Struct *zoltan, const hg_mpi_def &def, Rows *rows) {
  const std::string imbalance = std::to_string(def.imbalance);
  const char *const parameters[][2] = {{"DEBUG_LEVEL", "0"},
                                       {"LB_METHOD", def.balancer == HG_MPI_CURVE ? "HSFC" : "RCB"},
                                       {"NUM_GID_ENTRIES", "2"},
                                       {"NUM_LID_ENTRIES", "1"},
                                       {"OBJ_WEIGHT_DIM", "1"},
                                       {"RETURN_LISTS", "EXPORT"},
                                       {"IMBALANCE_TOL", imbalance.c_str()}};
  for (const auto &parameter : parameters) {
    check_zoltan(Zoltan_Set_Param(zoltan, parameter[0], parameter[1]), parameter[0]);
  }
  check_zoltan(Zoltan_Set_Num_Obj_Fn(zoltan, count_of, rows), "Zoltan_Set_Num_Obj_Fn");
  check_zoltan(Zoltan_Set_Obj_List_Fn(zoltan, list_of, rows), "Zoltan_Set_Obj_List_Fn");
  check_zoltan(Zoltan_Set_Num_Geom_Fn(zoltan, dimension_of, rows), "Zoltan_Set_Num_Geom_Fn");
  check_zoltan(Zoltan_Set_Geom_Multi_Fn(zoltan, places_of, rows), "Zoltan_Set_Geom_Multi_Fn");
}

}  // namespace

std::vector<int32_t> choose_owners(MPI_Comm comm, const hg_mpi_def &def, const Cell &cell, const Particles &particles,
                                   const std::vector<double> &weights) {
  int rank = 0;
  check_mpi(MPI_Comm_rank(comm, &rank), "MPI_Comm_rank");
  // How many there are at all, and the largest weight. Of nothing at all Zoltan makes no parts, and complains.
  double mine[2] = {static_cast<double>(weights.size()), 0}, most[2] = {0, 0};
  for (const double weight : weights) mine[1] = std::max(mine[1], weight);
  check_mpi(MPI_Allreduce(mine, most, 2, MPI_DOUBLE, MPI_MAX, comm), "MPI_Allreduce");
  std::vector<int32_t> owners;
  Rows rows{};
  together(comm, [&] {
    owners.assign(weights.size(), rank);
    rows = rows_of(rank, cell, particles, weights, most[1]);
  });
  if (most[0] == 0) return owners;

  float version = 0;
  check_zoltan(Zoltan_Initialize(0, nullptr, &version), "Zoltan_Initialize");
  const std::unique_ptr<Zoltan_Struct, DestroyZoltan> zoltan(Zoltan_Create(comm));
  together(comm, [&] {
    if (zoltan == nullptr) fail(HG_ERR_MEMORY, "Zoltan_Create failed");
    set_parameters(zoltan.get(), def, &rows);
  });
  Parts parts;
  const int code = Zoltan_LB_Partition(
      zoltan.get(), &parts.changes, &parts.global_entries, &parts.local_entries, &parts.import_count,
      &parts.import_global, &parts.import_local, &parts.import_ranks, &parts.import_parts, &parts.export_count,
      &parts.export_global, &parts.export_local, &parts.export_ranks, &parts.export_parts);
  together(comm, [&] {
    check_zoltan(code, "Zoltan_LB_Partition");
    for (int k = 0; k < parts.export_count; k++) owners[parts.export_local[k]] = parts.export_ranks[k];
  });
  return owners;
}

}  // namespace hgrid::mpi
