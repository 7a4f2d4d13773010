// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The neighbour list of a textbook: searched with a margin, then filtered by distance for a fixed number of steps,
// whatever the particles do meanwhile.
#pragma once

#include "particles/particle_set.hpp"

#include <hgrid/hgrid.hpp>

#include <vector>

namespace accuracy {

class KeptList {
 public:
  // Searches now and at every `interval`-th step from here. Three dimensions, no periodic axes.
  KeptList(const particles::ParticleSet &start, double margin, int interval);

  // The pairs found among particles that have moved by one more step. True if they were searched anew.
  bool step(const particles::ParticleSet &particles);

  const std::vector<hg_pair> &pairs() const { return pairs_; }  // of the last step
  const std::vector<hg_pair> &candidates() const { return candidates_; }

 private:
  void search(const particles::ParticleSet &particles);

  hgrid::Grid grid_;
  int interval_, age_ = 0;
  std::vector<hg_pair> candidates_, pairs_;
};

// Overlap over the smaller of the two radii.
double relative_overlap(const particles::ParticleSet &particles, const hg_pair &pair);

}  // namespace accuracy
