// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which levels a grid gets: by the caller's rule, from the sizes and a sample of the places of its particles.
#pragma once

#include "src/levels/level_plan.hpp"
#include "src/levels/work_cost.hpp"
#include "src/particles/participants.hpp"

namespace hg {

// The part of hg_grid_def that is about levels, checked.
struct LevelSettings {
  int32_t rule = HG_LEVELS_AUTO;
  int level_count = 0;
  double cell_sizes[HG_MAX_LEVELS] = {};
  double cell_overhead = 0;  // K, where Eq. 7 decides
  bool counts_work = false;  // `prices` decide instead
  WorkPrices prices;

  // What the coarsest cell can hold; infinite if cells follow the particles.
  double largest_diameter() const;
};

class LevelChoice {
 public:
  LevelChoice(Memory &memory, const LevelSettings &settings, const Interaction &interaction)
      : settings_(settings), interaction_(interaction), classes_(memory) {}

  // The size classes are kept while only centres move.
  void radii_changed() { classes_made_ = false; }
  // For a store without gaps; `wide`: the interaction, wider by a skin or not.
  LevelPlan choose(const Participants &particles, const FixedPoint &map, const FilledVolume &volume,
                   const Interaction &wide);

 private:
  LevelPlan user_plan(const Participants &particles, double skin) const;
  void make_classes(const Participants &particles);

  LevelSettings settings_;
  Interaction interaction_;
  SizeClasses classes_;
  bool classes_made_ = false;
};

}  // namespace hg
