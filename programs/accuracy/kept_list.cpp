// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The list is the library's, the filter plain.
#include "programs/accuracy/kept_list.hpp"

#include "particles/insert.hpp"
#include "programs/measure/search_timer.hpp"

#include <algorithm>
#include <cmath>

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

KeptList::KeptList(const particles::ParticleSet &start, double margin, int interval)
    : grid_(def_of(start, margin)), interval_(interval) {
  particles::insert(start, grid_);
  search(start);
}

void KeptList::search(const particles::ParticleSet &particles) {
  grid_.move(particles.count(), particles.centers.data());
  const hgrid::View<hg_pair> found = grid_.query_pairs();
  candidates_.assign(found.begin(), found.end());
  age_ = 0;
}

bool KeptList::step(const particles::ParticleSet &particles) {
  const bool searches = ++age_ >= interval_;
  if (searches) search(particles);
  const double *centers = particles.centers.data(), *radii = particles.radii.data();
  pairs_.clear();
  for (const hg_pair &pair : candidates_) {
    if (overlap(centers + 3 * size_t(pair.a), centers + 3 * size_t(pair.b), radii[pair.a] + radii[pair.b])) {
      pairs_.push_back(pair);
    }
  }
  return searches;
}

double relative_overlap(const particles::ParticleSet &particles, const hg_pair &pair) {
  double square = 0;
  for (size_t k = 0; k < 3; k++) {
    const double d = particles.centers[3 * size_t(pair.a) + k] - particles.centers[3 * size_t(pair.b) + k];
    square += d * d;
  }
  const double r_a = particles.radii[size_t(pair.a)], r_b = particles.radii[size_t(pair.b)];
  return (r_a + r_b - std::sqrt(square)) / std::min(r_a, r_b);
}

}  // namespace accuracy
