// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The list is the library's, the filter plain.
#include "programs/accuracy/search/verlet_list.hpp"

#include "programs/accuracy/contacts.hpp"
#include "programs/measure/search_timer.hpp"

namespace accuracy {
namespace {

hg_grid_def def_of(const particles::ParticleSet &particles, double margin) {
  hg_grid_def def = measure::def_of(particles);
  def.thread_count = 1;
  def.margin = margin;
  return def;
}

}  // namespace

VerletList::VerletList(const particles::ParticleSet &start, double margin, int interval)
    : grid_(def_of(start, margin), start),
      interval_(interval),
      candidates_(grid_.pairs().begin(), grid_.pairs().end()) {}

void VerletList::step(const particles::ParticleSet &particles) {
  if (++age_ >= interval_) {
    grid_.step(particles);
    candidates_.assign(grid_.pairs().begin(), grid_.pairs().end());
    age_ = 0;
  }
  pairs_.clear();
  filter_pairs(particles, candidates_, pairs_);
}

}  // namespace accuracy
