// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The caller's hg_grid_def, checked and copied.
#pragma once

#include "src/exact/domain.hpp"
#include "src/exact/interaction.hpp"
#include "src/levels/level_choice.hpp"

#include <hgrid/types.h>

namespace hg {

struct Definition {
  int dimension = 3;
  int thread_count = 0;
  int32_t index_base = 0;
  int32_t accuracy = HG_EXACT;
  int32_t pair_order = HG_ORDER_GRID;
  double skin = 0;
  LevelSettings levels;
  Interaction interaction;
  Domain domain;
};

void fill_defaults(hg_grid_def *def, size_t struct_size);

// Throws an Error that names the member and its value.
Definition check_definition(const hg_grid_def &given);

// The domain with another box on its periodic axes, checked in the same way; three values each, tilt may be NULL.
Domain change_box(const Domain &domain, const double *box_min, const double *box_max, const double *tilt);

}  // namespace hg
