// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Spaces for tests, and the rule of a space as the oracle of tests/support reads it.
#pragma once

#include "src/exact/domain.hpp"
#include "src/exact/interaction.hpp"

#include <hgrid/types.h>

namespace hgtest {

inline hg::Domain open_space(int dimension) {
  hg::Domain domain;
  domain.dimension = dimension;
  return domain;
}

inline void set_box(hg::Domain &domain, int axis, double low, double high, bool periodic = true) {
  domain.periodic[axis] = periodic;
  domain.any_periodic = domain.any_periodic || periodic;
  domain.box_min[axis] = low;
  domain.box_max[axis] = high;
  domain.length[axis] = high - low;
}

inline hg_grid_def rule_of(const hg::Domain &domain, const hg::Interaction &interaction = {}) {
  hg_grid_def rule{};
  rule.dimension = domain.dimension;
  rule.interaction = interaction.kind;
  rule.margin = interaction.margin;
  for (int axis = 0; axis < domain.dimension; axis++) {
    rule.periodic[axis] = domain.periodic[axis] ? 1 : 0;
    rule.box_min[axis] = domain.box_min[axis];
    rule.box_max[axis] = domain.box_max[axis];
  }
  return rule;
}

}  // namespace hgtest
