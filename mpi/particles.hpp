// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The particles that a rank knows: those that it owns, then ghosts; and one of them as it travels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace hgrid::mpi {

// Sent between ranks as bytes.
struct Traveller {
  int64_t gid;
  double center[3];
  double radius;
  double weight;  // in hg_mpi_balance
  int32_t group, body;
};

struct Particles {
  size_t dimension = 3;
  std::vector<int64_t> gids;
  std::vector<double> centers, radii;  // [count][dimension], [count]
  std::vector<int32_t> groups, bodies;

  size_t count() const { return gids.size(); }
  const double *center(size_t k) const { return &centers[k * dimension]; }
  void resize(size_t count) {
    gids.resize(count);
    centers.resize(count * dimension);
    radii.resize(count);
    groups.resize(count);
    bodies.resize(count);
  }
  Traveller pack(size_t k, double weight) const {
    Traveller row{gids[k], {0, 0, 0}, radii[k], weight, groups[k], bodies[k]};
    std::memcpy(row.center, center(k), dimension * sizeof(double));
    return row;
  }
  void unpack(size_t k, const Traveller &row) {
    gids[k] = row.gid;
    std::memcpy(&centers[k * dimension], row.center, dimension * sizeof(double));
    radii[k] = row.radius;
    groups[k] = row.group;
    bodies[k] = row.body;
  }
};

}  // namespace hgrid::mpi
