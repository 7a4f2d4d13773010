// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// The neighbour list of a textbook: searched with a margin, then filtered by distance for a fixed number of steps,
// whatever the particles do meanwhile.
#ifndef APP_ACCURACY_KEPT_LIST_HPP
#define APP_ACCURACY_KEPT_LIST_HPP

#include "grid_handle.hpp"
#include "particles/particle_set.hpp"

#include <hgrid/hgrid.h>

#include <vector>

namespace accuracy {

class KeptList {
 public:
  // Searches now and at every `interval`-th step from here. Three dimensions, no periodic axes.
  KeptList(const app::ParticleSet &start, double margin, int interval);

  // The pairs found among particles that have moved by one more step. True if they were searched anew.
  bool step(const app::ParticleSet &particles);

  const std::vector<hg_pair> &pairs() const { return pairs_; }  // of the last step
  const std::vector<hg_pair> &candidates() const { return candidates_; }

 private:
  void search(const app::ParticleSet &particles);

  app::Grid grid_;
  int interval_, age_ = 0;
  std::vector<hg_pair> candidates_, pairs_;
};

// Overlap over the smaller of the two radii.
double relative_overlap(const app::ParticleSet &particles, const hg_pair &pair);

}  // namespace accuracy

#endif
