// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A box around a point, in doubles, that holds the centres of all its partners.
#pragma once

#include "src/exact/domain.hpp"

namespace hg {

struct Window {
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};  // positions as in Domain::position

  // Around the given image of a centre. Rounding is monotone: if |x - y| < reach then y lies between the rounded ends.
  // The factor makes up for the rounding of the reach itself; positions wrapped into a box, and what HG_DOUBLE computes
  // across it, are off by less than 2^-28 box lengths.
  static Window around(const Domain &domain, const double *center, Image image, double reach) {
    const double enough = reach * (1.0 + 0x1p-50);
    Window window;
    for (int k = 0; k < domain.dimension; k++) {
      double x = domain.position(k, center[k]);
      double slack = 0;
      if (domain.periodic[k]) {
        x += image_step(image, k) * domain.length[k];
        slack = 0x1p-28 * domain.length[k];
      }
      window.low[k] = x - (enough + slack);
      window.high[k] = x + (enough + slack);
    }
    return window;
  }

  // Open axes have no box to miss.
  bool misses_box(const Domain &domain) const {
    for (int k = 0; k < domain.dimension; k++) {
      if (domain.periodic[k] && (high[k] < 0 || low[k] > domain.length[k])) return true;
    }
    return false;
  }
};

}  // namespace hg
