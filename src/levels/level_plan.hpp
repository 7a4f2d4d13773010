// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How many levels, and how large their cells: Ogarko & Luding, Comput. Phys. Commun. 183 (2012) 931, section 3.2 and
// Appendix A. Symbols are the paper's: L levels, cell edges s_h, N_h particles on level h, m_h particles per cell.
#pragma once

#include "src/exact/interaction.hpp"
#include "src/levels/cost_model.hpp"
#include "src/levels/size_classes.hpp"
#include "src/space/bounds.hpp"

#include <hgrid/types.h>

#include <cstdint>

namespace hg {

struct PlannedLevel {
  double cell_size = 0;     // s_h
  double radius_limit = 0;  // the largest radius that the level takes
  int64_t particles = 0;    // N_h
};

struct LevelPlan {
  int level_count = 0;
  PlannedLevel levels[HG_MAX_LEVELS];
  int cost_count = 0;
  hg_level_cost costs[HG_MAX_LEVELS];
};

// The volume V that the particles fill.
struct FilledVolume {
  int dimension = 3;  // d
  double edge = 0;    // S, S^d = V

  static FilledVolume of(const Bounds &bounds, int dimension);
};

// m_h = N_h s_h^d / V: the mean number of particles per cell (the paper's N_h / N_c^h, N_c^h a real number).
double occupancy(int64_t particles, double cell_size, const FilledVolume &volume);

struct LevelRequest {
  FilledVolume volume;
  int level_count = 0;   // at most that many; 0 = the cheapest
  double precision = 0;  // relative, of m(L); 0 = to the last bit
  Interaction interaction;
};

// The levels that make m_h equal (Eq. 6), as many as cost least.
LevelPlan plan_levels(const SizeClasses &classes, const LevelRequest &request, const CostModel &costs);

// The levels of the caller, s_h = cell_sizes[h].
LevelPlan user_levels(const double *cell_sizes, int count, const Interaction &interaction);

}  // namespace hg
