// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The paper's search box (Eq. 4) in doubles: it holds the centres of all partners of a ball.
#pragma once

#include "src/exact/domain.hpp"

namespace hg {

struct SearchBox {
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};  // positions as in Domain::position

  // Around the given image of a centre: x- and x+ of Eq. 4, a = reach. Rounding is monotone: if |x - y| < reach then y
  // lies between the rounded ends. The factor makes up for the rounding of the reach itself; positions wrapped into a
  // box, and what HG_DOUBLE computes across it, are off by less than 2^-28 box lengths.
  static SearchBox around(const Domain &domain, const double *center, Image image, double reach) {
    const double enough = reach * (1.0 + 0x1p-50);
    SearchBox box;
    for (int axis = 0; axis < domain.dimension; axis++) {
      double x = domain.position(axis, center[axis]);
      double slack = 0;
      if (domain.periodic[axis]) {
        x += image_step(image, axis) * domain.length[axis];
        slack = 0x1p-28 * domain.length[axis];
      }
      box.low[axis] = x - (enough + slack);
      box.high[axis] = x + (enough + slack);
    }
    return box;
  }

  // Open axes have no period to lie outside of.
  bool misses(const Domain &domain) const {
    for (int axis = 0; axis < domain.dimension; axis++) {
      if (domain.periodic[axis] && (high[axis] < 0 || low[axis] > domain.length[axis])) return true;
    }
    return false;
  }
};

}  // namespace hg
