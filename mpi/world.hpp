// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// All particles of a communicator, as one rank sees them: what it owns, which ghosts it needs and who needs its own.
#pragma once

#include "mpi/local_search.hpp"
#include "mpi/particles.hpp"
#include "mpi/route.hpp"
#include "mpi/selection.hpp"

#include <hgrid/mpi.h>

namespace hgrid::mpi {

class World {
 public:
  // Takes `comm`, a duplicate, and frees it in the end.
  World(MPI_Comm comm, const hg_grid_def &grid_def, const hg_mpi_def &def);
  ~World();
  World(const World &) = delete;
  World &operator=(const World &) = delete;

  MPI_Comm comm() const { return comm_; }
  bool is_visited() const { return search_.is_visited(); }

  // Collective.
  void set(size_t count, const int64_t *gids, const double *centers, const double *radii);
  void balance(const double *weights);
  void migrate(size_t row_bytes, const void *before, void *after);
  bool move(size_t count, const double *centers, const double *radii);
  void set_groups(size_t count, const int32_t *groups);
  void set_group_pair(int32_t group_a, int32_t group_b, int32_t interacts);
  void set_bodies(size_t count, const int32_t *bodies);
  void forward(size_t row_bytes, const void *owned, void *ghosts);
  void add_back(size_t columns, const double *ghosts, double *owned);

  // Local.
  void check_usable() const;
  LocalSearch &search() { return search_; }
  size_t owned_count() const { return owned_; }
  const Particles &particles() const { return particles_; }
  const std::vector<int32_t> &ghost_owners() const { return ghost_owners_; }
  hg_mpi_stats stats() const;

 private:
  void check_call() const;
  void check_numbers(size_t count, const double *centers, const double *radii);
  bool may_be_outside(size_t count, const double *centers) const;
  void check_cell(size_t count, const double *radii);
  bool moved_too_far(const double *centers, const double *radii) const;
  void choose_ghosts();
  BoxesOfRanks gather_boxes(const std::vector<SizeBox> &mine) const;
  void update_ghosts();
  void spread(size_t count, const int32_t *numbers, int32_t none, std::vector<int32_t> Particles::*column);
  std::vector<double> weights_of_pairs();
  double imbalance_of(double weight) const;

  MPI_Comm comm_;
  int rank_ = 0, size_ = 1;
  hg_grid_def grid_def_;
  hg_mpi_def def_;
  ReachRule rule_;
  LocalSearch search_;
  GridHandle judge_;  // a grid that says whether particles are fine: the two largest of all ranks, or those far outside
  std::vector<double> largest_;

  bool usable_ = false;    // after hg_mpi_set, unless a call failed midway since
  bool balanced_ = false;  // since hg_mpi_set
  size_t owned_ = 0;
  Particles particles_;  // the owned ones, then ghosts
  std::vector<int32_t> ghost_owners_;
  std::vector<double> chosen_centers_, chosen_radii_;  // of owned particles when ghosts were chosen
  Route ghosts_, migration_;
  int64_t selection_count_ = 0, update_count_ = 0;
  double imbalance_ = 1;
};

// Throws on all ranks if a gid stands twice. Collective.
void check_unique(MPI_Comm comm, const std::vector<int64_t> &gids);

// For each owned particle the rank that shall own it. Collective; HG_ERR_STATE without Zoltan.
std::vector<int32_t> choose_owners(MPI_Comm comm, const hg_mpi_def &def, const Cell &cell, const Particles &particles,
                                   const std::vector<double> &weights);

}  // namespace hgrid::mpi
