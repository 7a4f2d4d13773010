// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/shapes.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>

namespace oracle {
namespace {

mpz_class floor_of(const mpq_class &x) {
  mpz_class whole;
  mpz_fdiv_q(whole.get_mpz_t(), x.get_num().get_mpz_t(), x.get_den().get_mpz_t());
  return whole;
}

// From y to the interval.
mpq_class gap(const mpq_class &y, double low, double high) {
  if (std::isfinite(low) && y < mpq_class(low)) return mpq_class(low) - y;
  if (std::isfinite(high) && y > mpq_class(high)) return y - mpq_class(high);
  return 0;
}

// Of all images on a periodic axis only the last one below the box and the first one not below it can be nearest.
mpq_class least_gap(const hg_grid_def &def, int axis, double x, double low, double high) {
  if (def.periodic[axis] == 0) return gap(mpq_class(x), low, high);
  if (!std::isfinite(low) || !std::isfinite(high)) return 0;
  const mpq_class length = mpq_class(def.box_max[axis]) - mpq_class(def.box_min[axis]);
  const mpq_class images(floor_of((mpq_class(low) - mpq_class(x)) / length));
  const mpq_class below = mpq_class(x) + images * length;
  return std::min(gap(below, low, high), gap(below + length, low, high));
}

}  // namespace

bool box_meets(const hg_grid_def &def, const double *low, const double *high, const Sphere &particle) {
  mpq_class distance2 = 0, reach = mpq_class(particle.radius) + mpq_class(def.margin);
  for (int axis = 0; axis < def.dimension; axis++) {
    if (low[axis] == HUGE_VAL || high[axis] == -HUGE_VAL) return false;
    const mpq_class d = least_gap(def, axis, particle.center[axis], low[axis], high[axis]);
    distance2 += d * d;
  }
  const int order = cmp(distance2, reach * reach);
  return distance2 == 0 || order < 0 || (order == 0 && def.touching != 0);
}

}  // namespace oracle
