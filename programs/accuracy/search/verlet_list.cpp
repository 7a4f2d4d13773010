// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The list is the library's, the filter plain.
#include "programs/accuracy/search/verlet_list.hpp"

#include "programs/measure/search_timer.hpp"

namespace accuracy {
namespace {

hg_grid_def def_of(const particles::ParticleSet &particles, double margin) {
  hg_grid_def def = measure::def_of(particles);
  def.thread_count = 1;
  def.margin = margin;
  return def;
}

// As HG_DOUBLE decides: the same operations in the same order.
bool overlap(const double *x, const double *y, double reach) {
  const double dx = x[0] - y[0], dy = x[1] - y[1], dz = x[2] - y[2];
  return dx * dx + dy * dy + dz * dz < reach * reach;
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
  const double *centers = particles.centers.data(), *radii = particles.radii.data();
  pairs_.clear();
  for (const hg_pair &pair : candidates_) {
    if (overlap(centers + 3 * size_t(pair.a), centers + 3 * size_t(pair.b), radii[pair.a] + radii[pair.b])) {
      pairs_.push_back(pair);
    }
  }
}

}  // namespace accuracy
