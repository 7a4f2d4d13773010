// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How the library is timed: from double arrays in memory to the complete list of pairs.
#pragma once

#include "particles/insert.hpp"
#include "programs/measure/statistics.hpp"
#include "programs/measure/timing.hpp"

#include <hgrid/hgrid.hpp>

#include <optional>
#include <vector>

namespace measure {

// The defaults for these particles: their dimension and box.
inline hg_grid_def def_of(const particles::ParticleSet &particles) {
  hg_grid_def def = hg_default_grid_def();
  particles::set_box(particles, def);
  return def;
}

// One grid, filled and searched anew in each run; it keeps its memory between runs as a simulation's would.
class SearchTimer {
 public:
  // `particles` must outlive the timer.
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
  double ns_per_particle() const { return 1e9 * median(seconds_) / static_cast<double>(particles_->count()); }
  // Of the last run.
  const hgrid::View<hg_pair> &pairs() const { return pairs_; }
  hgrid::Grid &grid() { return grid_; }
  size_t level_count() { return grid_.query_levels().size(); }

 private:
  hgrid::Grid grid_;
  const particles::ParticleSet *particles_;
  hgrid::View<hg_pair> pairs_;
  std::vector<double> seconds_;
};

// What the library expects of a search on so many levels, if it can make as many. The grid must be filled.
inline std::optional<hg_level_cost> expected_cost(hgrid::Grid &grid, size_t level_count) {
  for (const hg_level_cost &cost : grid.query_level_costs()) {
    if (cost.reachable != 0 && static_cast<size_t>(cost.level_count) == level_count) return cost;
  }
  return std::nullopt;
}

// One timer for each number of levels, up to `most`, that the sizes can be split into; its grid is filled.
inline std::vector<SearchTimer> timers_by_level_count(hg_grid_def def, const particles::ParticleSet &particles,
                                                      int most) {
  std::vector<SearchTimer> timers;
  for (def.level_count = 1; def.level_count <= most; def.level_count++) {
    SearchTimer timer(def, particles);
    particles::insert(particles, timer.grid());
    if (timer.level_count() == static_cast<size_t>(def.level_count)) timers.push_back(std::move(timer));
  }
  return timers;
}

}  // namespace measure
