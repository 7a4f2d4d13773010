// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What levels cost, per particle, in units of one test: the interface of the models that a number of levels is chosen
// by.
#pragma once

#include <cstddef>

namespace hg {

// Size classes [first, end) of a level.
struct ClassRange {
  size_t first, end;
};

// The sizes, split into levels, finest first.
struct LevelSplit {
  int level_count;            // L
  const ClassRange *classes;  // of each level
  double occupancy;           // m, the largest m_h
};

class CostModel {
 public:
  virtual double cost(const LevelSplit &levels) const = 0;
  // Whether no number of levels from this one on can be, or is likely to be, cheaper than `best`, when so many in a row
  // were dearer.
  virtual bool looked_enough(int level_count, double best, int dearer_in_a_row) const = 0;

 protected:
  ~CostModel() = default;
};

}  // namespace hg
