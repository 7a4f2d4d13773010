// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The search of one rank: a grid over what it owns and its ghosts, and of the pairs found those that are its own.
#pragma once

#include "mpi/particles.hpp"

#include <hgrid/hgrid.h>

#include <array>
#include <memory>

namespace hgrid::mpi {

struct DestroyGrid {
  void operator()(hg_grid *grid) const { hg_destroy(grid); }
};
using GridHandle = std::unique_ptr<hg_grid, DestroyGrid>;

GridHandle make_grid(const hg_grid_def &def);

class LocalSearch {
 public:
  explicit LocalSearch(const hg_grid_def &def);

  // Other particles, of which the first `owned` are owned.
  void set(const Particles &particles, size_t owned);
  // The same ones elsewhere.
  void move(const Particles &particles);
  void set_groups(const Particles &particles);
  void set_bodies(const Particles &particles);
  void set_group_pair(int32_t group_a, int32_t group_b, bool interacts);

  const std::vector<hg_pair> &pairs();
  void visit(hg_pair_visitor *visit, void *context);
  bool is_visited() const { return visited_; }
  // Pairs of the last list or visit that was not stopped.
  int64_t pair_count() const { return pair_count_; }
  int opened_axis_count() const { return opened_[0] + opened_[1] + opened_[2]; }

 private:
  using Axes = std::array<bool, 3>;
  struct Visit;

  static int32_t forward_batch(void *context, const hg_pair *pairs, size_t count);
  Axes axes_to_open(const Particles &particles) const;
  void open(const Axes &axes);
  void fill(const Particles &particles);
  // Whether a pair of the grid belongs to this rank: the smaller of the two is owned.
  bool is_own(const hg_pair &pair) const;

  hg_grid_def def_;
  std::vector<double> cell_sizes_;
  std::vector<uint8_t> interacts_;  // [HG_MPI_MAX_GROUPS][HG_MPI_MAX_GROUPS]
  Axes opened_{false, false, false};
  GridHandle grid_;
  size_t owned_ = 0;
  std::vector<double> ranking_radii_;  // as they were when ghosts were chosen
  std::vector<int64_t> gids_;
  std::vector<int32_t> groups_;
  std::vector<hg_pair> pairs_;
  int64_t pair_count_ = 0;
  bool visited_ = false;
};

}  // namespace hgrid::mpi
