// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/levels/level_plan.hpp"

#include "src/base/ordered_bits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hg {
namespace {

class Planner {
 public:
  Planner(const SizeClasses &classes, const LevelRequest &request, const CostModel &costs)
      : classes_(classes), request_(request), costs_(costs) {}

  // Appendix A (Eq. 6) for one m: fills levels from the smallest particles up, starting the next level before m_h
  // exceeds m. Returns the number of levels, or HG_MAX_LEVELS + 1 if there would be more. A class is never split, and a
  // level is never empty even if its first class alone exceeds m.
  int assign(double m, PlannedLevel *levels, ClassRange *ranges = nullptr) const {
    int count = 0;
    for (size_t first = 0; first < classes_.count();) {
      if (count == HG_MAX_LEVELS) return HG_MAX_LEVELS + 1;
      const size_t end = std::max(first_over(first, m), first + 1);
      levels[count].radius_limit = classes_.largest_radius(end - 1);
      levels[count].cell_size = request_.interaction.diameter(levels[count].radius_limit);
      levels[count].particles = classes_.particles(first, end - 1);
      if (ranges != nullptr) ranges[count] = {first, end};
      count++;
      first = end;
    }
    return count;
  }

  // m(L) = min {m : at most L levels}. The number of levels falls as m grows, so bisection is exact.
  double least_occupancy(int level_count) const {
    PlannedLevel levels[HG_MAX_LEVELS];
    if (assign(0, levels) <= level_count) return 0;
    double too_small = 0;
    double enough = level_occupancy(0, classes_.count() - 1);
    while (enough - too_small > request_.precision * enough) {
      const double middle = too_small + 0.5 * (enough - too_small);
      if (middle <= too_small || middle >= enough) break;
      (assign(middle, levels) <= level_count ? enough : too_small) = middle;
    }
    return enough;
  }

  hg_level_cost cost(int level_count, PlannedLevel *levels) const {
    hg_level_cost cost{level_count, 0, 0, 0};
    ClassRange ranges[HG_MAX_LEVELS];
    if (assign(least_occupancy(level_count), levels, ranges) != level_count) return cost;
    cost.reachable = 1;
    for (int h = 0; h < level_count; h++) {
      cost.occupancy = std::max(cost.occupancy, occupancy(levels[h].particles, levels[h].cell_size, request_.volume));
    }
    cost.cost = costs_.cost({level_count, ranges, cost.occupancy});
    return cost;
  }

 private:
  // m_h of a level of the classes [first, last].
  double level_occupancy(size_t first, size_t last) const {
    return occupancy(classes_.particles(first, last), request_.interaction.diameter(classes_.largest_radius(last)),
                     request_.volume);
  }

  // The first class c >= first such that a level of [first, c] holds more than m particles per cell.
  size_t first_over(size_t first, double m) const {
    size_t low = first, high = classes_.count();
    while (low < high) {
      const size_t middle = low + (high - low) / 2;
      if (level_occupancy(first, middle) > m) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low;
  }

  const SizeClasses &classes_;
  const LevelRequest &request_;
  const CostModel &costs_;
};

// The largest r with diameter(r) <= s, so that levels are told apart by comparing radii alone; -1 if the margin alone
// does not fit. Bisects the bits, which order as the doubles do.
double largest_radius_within(double s, const Interaction &interaction) {
  if (interaction.diameter(0) > s) return -1;
  uint64_t fits = 0, too_large = bits_of(std::numeric_limits<double>::infinity());
  while (too_large - fits > 1) {
    const uint64_t middle = fits + (too_large - fits) / 2;
    (interaction.diameter(from_bits(middle)) <= s ? fits : too_large) = middle;
  }
  return from_bits(fits);
}

}  // namespace

// By roots first, so that no product overflows.
FilledVolume FilledVolume::of(const Bounds &bounds, int dimension) {
  FilledVolume volume{dimension, 1};
  for (int axis = 0; axis < dimension; axis++) volume.edge *= std::pow(bounds.width[axis], 1.0 / dimension);
  return volume;
}

double occupancy(int64_t particles, double cell_size, const FilledVolume &volume) {
  if (particles == 0) return 0;
  // All particles in one point fill no volume: whatever the cells, they meet each other.
  if (!(volume.edge > 0)) return cell_size > 0 ? static_cast<double>(particles) : 0;
  const double ratio = cell_size / volume.edge;
  const double cell_volume = volume.dimension == 3 ? ratio * ratio * ratio : ratio * ratio;
  return std::min(static_cast<double>(particles) * cell_volume, std::numeric_limits<double>::max());
}

LevelPlan plan_levels(const SizeClasses &classes, const LevelRequest &request, const CostModel &costs) {
  LevelPlan plan;
  if (classes.count() == 0) return plan;
  const Planner planner(classes, request, costs);
  PlannedLevel levels[HG_MAX_LEVELS];
  double best = std::numeric_limits<double>::infinity();
  int dearer = 0;
  const int wanted = request.level_count;
  const int last = wanted > 0 ? wanted : HG_MAX_LEVELS;
  for (int level_count = 1; level_count <= last; level_count++) {
    if (wanted == 0 && costs.looked_enough(level_count, best, dearer)) break;
    const hg_level_cost cost = planner.cost(level_count, levels);
    plan.costs[plan.cost_count++] = cost;
    if (cost.reachable == 0) continue;
    dearer = cost.cost >= best ? dearer + 1 : 0;
    if (wanted == 0 && plan.level_count > 0 && cost.cost >= best) continue;
    best = cost.cost;
    plan.level_count = level_count;
    std::copy(levels, levels + level_count, plan.levels);
  }
  return plan;
}

LevelPlan user_levels(const double *cell_sizes, int count, const Interaction &interaction) {
  LevelPlan plan;
  plan.level_count = count;
  for (int h = 0; h < count; h++) {
    plan.levels[h].cell_size = cell_sizes[h];
    plan.levels[h].radius_limit = largest_radius_within(cell_sizes[h], interaction);
  }
  return plan;
}

}  // namespace hg
