// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What levels cost this library: the work of its own search, counted from the sizes, and the price of each kind.
// docs/theory/algorithm.md, section 4, derives the counts.
#pragma once

#include "src/exact/interaction.hpp"
#include "src/levels/cost_model.hpp"
#include "src/levels/density.hpp"
#include "src/levels/size_classes.hpp"
#include "src/space/fixed_point.hpp"

namespace hg {

// Expected work per particle. Tests are the unit of cost.
struct LevelWork {
  double levels = 0;  // passes over the particles in which they are told apart
  double rows = 0;    // rows of finer levels that a search looks at
  double tests = 0;   // candidates
};

// A price that the library knows better than the caller.
inline constexpr double kFittedPrice = -1;

// The prices, of a test = 1.
struct WorkPrices {
  double level = kFittedPrice, row = kFittedPrice;

  // With the fitted ones in place, for so many particles. docs/decisions/0018-levels-by-cost.md.
  WorkPrices fitted(size_t particles) const;
  double of(const LevelWork &work) const { return level * work.levels + row * work.rows + work.tests; }
};

class WorkCost final : public CostModel {
 public:
  // Refers to all that it is given but the prices; bin_radii made the classes.
  WorkCost(const SizeClasses &classes, const Interaction &interaction, const FixedPoint &map, int dimension,
           const Density &density, const WorkPrices &prices);

  double cost(const LevelSplit &levels) const override { return prices_.of(work(levels)); }
  bool looked_enough(int level_count, double best, int dearer_in_a_row) const override;
  LevelWork work(const LevelSplit &levels) const;

 private:
  struct Level;

  // Mean of (slope rho + beta)^n, n = 0 .. 3, over the particles of a level.
  void mean_powers(const Level &level, double slope, double beta, double *powers) const;
  Level level_of(const ClassRange &range) const;
  void add_search(const Level &searcher, const Level &target, bool own, LevelWork &work) const;

  const SizeClasses &classes_;
  const Interaction &interaction_;
  const FixedPoint &map_;
  int dimension_;
  const Density &density_;
  WorkPrices prices_;
  double particles_;
  double sums_[3][SizeClasses::kBins + 1];  // of r, r^2, r^3, r in quanta, over the classes before one
};

}  // namespace hg
