// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What levels cost this library: the work of its own search, counted from the sizes, and the price of each kind.
// docs/algorithm.md, section 4, derives the counts.
#pragma once

#include "src/exact/interaction.hpp"
#include "src/levels/filling.hpp"
#include "src/levels/size_classes.hpp"
#include "src/space/frame.hpp"

#include <hgrid/types.h>

#include <cstddef>

namespace hg {

// Expected work per particle. Tests are the unit of cost.
struct LevelWork {
  double levels = 0;  // passes over the particles in which they are told apart
  double rows = 0;    // rows of finer levels that a search looks at
  double tests = 0;   // candidates
};

// The prices, of a test = 1.
struct WorkPrices {
  double level = 0, row = 0;
  double of(const LevelWork &work) const { return level * work.levels + row * work.rows + work.tests; }
};

// Classes [first, end) of the sizes.
struct ClassRange {
  size_t first, end;
};

class LevelCost {
 public:
  // Refers to `classes`, which bin_radii made.
  LevelCost(const SizeClasses &classes, const Interaction &interaction, const Frame &frame, int dimension,
            const Filling &filling);

  // Of a grid whose level h holds the classes levels[h], finest first.
  LevelWork work(const ClassRange *levels, int count) const;

 private:
  struct Level;

  // Mean of (rho + beta)^n, n = 0 .. 3, over the particles of a level.
  void mean_powers(const Level &level, double beta, double *powers) const;
  Level level_of(const ClassRange &range) const;
  void add_search(const Level &searcher, const Level &target, bool own, LevelWork &work) const;

  const SizeClasses &classes_;
  const Interaction &interaction_;
  const Frame &frame_;
  int dimension_;
  const Filling &filling_;
  double particles_;
  double sums_[3][SizeClasses::kBins + 1];  // of r, r^2, r^3, r in quanta, over the classes before one
};

}  // namespace hg
