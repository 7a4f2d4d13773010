// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Random changes of who may be whose partner.
#pragma once

#include "tests/support/company.hpp"
#include "tests/support/scenes.hpp"

namespace hgtest {

inline void change_groups(Rng &rng, Company &company, const Grid &grid) {
  if (rng.chance(0.1)) {
    for (Member &member : company.members) member.group = 0;
    hgrid::check(hg_set_groups(grid.get(), 0, nullptr));
    return;
  }
  const double absent = rng.chance(0.1) ? 1 : rng.chance(0.5) ? 0 : rng.uniform();
  const int32_t last = rng.chance(0.2) ? HG_MAX_GROUPS - 1 : rng.integer(0, 3);
  for (Member &member : company.members) member.group = rng.chance(absent) ? -1 : rng.integer(0, last);
  company.tell_groups(grid);
}

inline void change_bodies(Rng &rng, Company &company, const Grid &grid) {
  if (rng.chance(0.2)) {
    for (Member &member : company.members) member.body = -1;
    hgrid::check(hg_set_bodies(grid.get(), 0, nullptr));
    return;
  }
  const int32_t last = rng.chance(0.5) ? 3 : 1 + static_cast<int32_t>(company.members.size() / 4);
  for (Member &member : company.members) member.body = rng.chance(0.3) ? -1 : rng.integer(0, last) * 100000;
  company.tell_bodies(grid);
}

inline void change_pair(Rng &rng, Company &company, const Grid &grid) {
  const int32_t last = rng.chance(0.2) ? HG_MAX_GROUPS - 1 : 3;
  const int32_t a = rng.integer(0, last), b = rng.chance(0.3) ? a : rng.integer(0, last);
  company.set_pair(grid, a, b, rng.chance(0.4));
}

// Tells the grid something else, or what it knows already.
inline void change_company(Rng &rng, Company &company, const Grid &grid) {
  switch (rng.below(4)) {
    case 0:
      change_groups(rng, company, grid);
      break;
    case 1:
      change_bodies(rng, company, grid);
      break;
    case 2:
      change_pair(rng, company, grid);
      break;
    default:
      company.tell_groups(grid);
      company.tell_bodies(grid);
  }
}

}  // namespace hgtest
