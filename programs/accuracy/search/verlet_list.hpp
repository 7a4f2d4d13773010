// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The neighbour list of a textbook: searched with a margin, then filtered by distance for a fixed number of steps,
// whatever the particles do meanwhile.
#pragma once

#include "programs/measure/step_timer.hpp"

#include <hgrid/hgrid.h>

#include <vector>

namespace accuracy {

class VerletList {
 public:
  // Searches now and at every `interval`-th step from here. Three dimensions, no periodic axes.
  VerletList(const particles::ParticleSet &start, double margin, int interval);

  // Finds the pairs of particles that have moved by one more step.
  void step(const particles::ParticleSet &particles);

  bool has_searched() const { return age_ == 0; }  // in the last step
  const std::vector<hg_pair> &pairs() const { return pairs_; }

 private:
  measure::MovingGrid grid_;
  int interval_, age_ = 0;
  std::vector<hg_pair> candidates_, pairs_;
};

}  // namespace accuracy
