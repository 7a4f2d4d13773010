// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The paper's search box (Eq. 4) in doubles: it holds the centres of all partners of a ball.
#pragma once

#include "src/exact/domain.hpp"
#include "src/space/shifts.hpp"

namespace hg {

// What may be added to a reach for the places of two particles and for what HG_DOUBLE computes across the box: less
// than 2^-28 lengths of it.
inline double place_slack(const Domain &domain, int axis) { return 0x1p-28 * domain.period(axis); }

// Around a place as Domain::take_in gives it, moved by a shift: x- and x+ of Eq. 4, a = reach. Rounding is monotone: if
// |x - y| < reach then y lies between the rounded ends. The factor makes up for the rounding of the reach itself.
inline PlaceBox search_box(const Domain &domain, const double *place, const Shift &shift, double reach) {
  const double enough = reach * (1.0 + 0x1p-50);
  PlaceBox box;
  for (int axis = 0; axis < domain.dimension; axis++) {
    const double x = place[axis] + domain.shifted(axis, shift), slack = place_slack(domain, axis);
    box.low[axis] = x - (enough + slack);
    box.high[axis] = x + (enough + slack);
  }
  return box;
}

}  // namespace hg
