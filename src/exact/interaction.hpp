// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// When two particles interact, as a function of their radii alone.
#pragma once

#include <hgrid/types.h>

#include <algorithm>
#include <cstdint>

namespace hg {

struct Interaction {
  int32_t kind = HG_CONTACT;
  double margin = 0;

  // The distance below which two particles interact, in double arithmetic.
  double reach(double ri, double rj) const { return (kind == HG_CONTACT ? ri + rj : std::max(ri, rj)) + margin; }

  // The farthest that two particles of radius <= r can interact: the least edge of a cell on the level that holds them
  // (the paper's s_h >= 2 r, with margin and ranges taken in).
  double diameter(double r) const { return reach(r, r); }

  // For candidates that may come to interact: every reach longer by the skin.
  Interaction widened(double skin) const { return {kind, margin + skin}; }

  // Radii with the margin folded in, so that the kernels know neither: reach = rho_i + rho_j, or max(rho_i, rho_j).
  double folded_radius(double r) const { return kind == HG_CONTACT ? r + 0.5 * margin : r + margin; }
};

}  // namespace hg
