// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/levels/level_choice.hpp"

#include "src/levels/occupancy_cost.hpp"

#include <algorithm>
#include <limits>

namespace hg {
namespace {

constexpr double kFittedPrecision = 1e-3;  // of m(L) for HG_LEVELS_AUTO, whose cost model is no better

}  // namespace

double LevelSettings::largest_diameter() const {
  return rule == HG_LEVELS_USER ? cell_sizes[level_count - 1] : std::numeric_limits<double>::infinity();
}

LevelPlan LevelChoice::user_plan(const Participants &particles, double skin) const {
  LevelPlan plan = user_levels(settings_.cell_sizes, settings_.level_count, interaction_);
  // The coarsest cells hold all particles as they are; with their margin they may be wider.
  if (particles.count() > 0) {
    const double largest = particles.summary().radius.greatest;
    PlannedLevel &coarsest = plan.levels[plan.level_count - 1];
    coarsest.radius_limit = std::max(coarsest.radius_limit, largest);
    coarsest.cell_size = std::max(coarsest.cell_size, interaction_.diameter(largest));
  }
  for (int h = 0; skin > 0 && h < plan.level_count; h++) {
    plan.levels[h].cell_size = (plan.levels[h].cell_size + skin) * (1 + 0x1p-40);
  }
  return plan;
}

void LevelChoice::make_classes(const Participants &particles) {
  if (classes_made_) return;
  if (settings_.rule == HG_LEVELS_PAPER) {
    classes_.sort_radii(particles.radii(), particles.count(), particles.summary().radius);
  } else {
    classes_.bin_radii(particles.radii(), particles.count(), particles.summary().radius);
  }
  classes_made_ = true;
}

LevelPlan LevelChoice::choose(const Participants &particles, const FixedPoint &map, const FilledVolume &volume,
                              const Interaction &wide) {
  if (settings_.rule == HG_LEVELS_USER) return user_plan(particles, wide.margin - interaction_.margin);
  make_classes(particles);
  const LevelRequest request{volume, settings_.level_count, settings_.rule == HG_LEVELS_PAPER ? 0 : kFittedPrecision,
                             wide};
  if (!settings_.counts_work || particles.count() == 0) {
    return plan_levels(classes_, request, OccupancyCost(settings_.cell_overhead));
  }
  const WorkPrices prices = settings_.prices.fitted(particles.count());
  // One size leaves no choice that would be worth a sample.
  const Density density = classes_.count() == 1 ? Density::even(map.extent, volume.dimension)
                                                : Density::sample(particles, map, volume.dimension);
  return plan_levels(classes_, request, WorkCost(classes_, wide, map, volume.dimension, density, prices));
}

}  // namespace hg
