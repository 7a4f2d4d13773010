// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How the library is timed: from double arrays in memory to the complete list of pairs.
#pragma once

#include "particles/insert.hpp"

#include <hgrid/hgrid.hpp>

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace measure {

// Half-way between the two middle ones of an even number; `samples` must not be empty.
inline double median(std::vector<double> samples) {
  std::sort(samples.begin(), samples.end());
  const size_t middle = samples.size() / 2;
  return samples.size() % 2 == 1 ? samples[middle] : 0.5 * (samples[middle - 1] + samples[middle]);
}

// Seconds that a call takes.
template <class Work>
double seconds_of(Work &&work) {
  const auto start = std::chrono::steady_clock::now();
  std::forward<Work>(work)();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The defaults for these particles: their dimension and box.
inline hg_grid_def def_of(const particles::ParticleSet &particles) {
  hg_grid_def def = hg_default_grid_def();
  def.dimension = particles.dimension;
  for (int k = 0; k < particles.dimension && particles.has_box; k++) {
    def.box_min[k] = particles.box_min[k];
    def.box_max[k] = particles.box_max[k];
    def.periodic[k] = particles.periodic[k];
  }
  return def;
}

// One grid, filled and searched anew in each run; it keeps its memory between runs as a simulation's would.
class SearchTimer {
 public:
  SearchTimer(const hg_grid_def &def, const particles::ParticleSet &particles) : grid_(def), particles_(&particles) {}

  // The grid is cleared, so neither levels nor pairs of the last run can be reused.
  void run() {
    seconds_.push_back(seconds_of([this] {
      grid_.clear();
      particles::insert(*particles_, grid_);
      pairs_ = grid_.query_pairs();
    }));
  }

  // Of all runs so far.
  const std::vector<double> &seconds() const { return seconds_; }
  double median_seconds() const { return median(seconds_); }
  double total_seconds() const {
    double total = 0;
    for (const double s : seconds_) total += s;
    return total;
  }
  // Of the last run.
  hgrid::View<hg_pair> pairs() const { return pairs_; }
  hgrid::Grid &grid() { return grid_; }

 private:
  hgrid::Grid grid_;
  const particles::ParticleSet *particles_;
  hgrid::View<hg_pair> pairs_;
  std::vector<double> seconds_;
};

}  // namespace measure
