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

inline void set_tilt(hg::Domain &domain, int higher, int lower, double tilt) {
  domain.tilt[hg::kTiltOf[higher][lower]] = tilt;
}

inline hg_grid_def rule_of(const hg::Domain &domain, const hg::Interaction &interaction = {}) {
  hg_grid_def rule{};
  rule.dimension = domain.dimension;
  rule.interaction = interaction.kind;
  rule.margin = interaction.margin;
  rule.touching = interaction.touching ? 1 : 0;
  rule.images = domain.all_images ? HG_ALL_IMAGES : HG_NEAREST_IMAGE;
  for (int axis = 0; axis < domain.dimension; axis++) {
    rule.periodic[axis] = domain.periodic[axis] ? 1 : 0;
    rule.box_min[axis] = domain.box_min[axis];
    rule.box_max[axis] = domain.box_max[axis];
  }
  for (int k = 0; k < 3; k++) rule.tilt[k] = domain.tilt[k];
  return rule;
}

}  // namespace hgtest
