// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The paper's model of what levels cost: a particle visits L cells, each of which costs K and holds m particles to
// test.
#pragma once

#include "src/levels/cost_model.hpp"

namespace hg {

class OccupancyCost final : public CostModel {
 public:
  explicit OccupancyCost(double cell_overhead) : cell_overhead_(cell_overhead) {}

  // L (m + K), Eq. 7.
  double cost(const LevelSplit &levels) const override {
    return levels.level_count * (levels.occupancy + cell_overhead_);
  }
  // The cost is at least L K. A table of some length is reported in any case.
  bool looked_enough(int level_count, double best, int /*dearer_in_a_row*/) const override {
    constexpr int kLeastLooked = 16;
    return level_count > kLeastLooked && level_count * cell_overhead_ >= best;
  }

 private:
  double cell_overhead_;  // K
};

}  // namespace hg
