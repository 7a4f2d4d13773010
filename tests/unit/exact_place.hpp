// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a centre lies in quanta, in rational numbers: what fixed-point coordinates are held against.
#pragma once

#include "src/space/fixed_point.hpp"
#include "tests/unit/checks.hpp"

#include <gmpxx.h>

namespace hgtest {

inline mpz_class floor_of(const mpq_class &x) {
  mpz_class quotient;
  mpz_fdiv_q(quotient.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  return quotient;
}

// What a map makes of a centre on one axis, where no tilt moves it: quanta, the place, the coordinate.
template <class Found, class Find>
Found on_axis(int axis, double center, Find &&find) {
  double x[3] = {0, 0, 0};
  Found found[3];
  x[axis] = center;
  find(x, found);
  return found[axis];
}
inline double quanta_of(const hg::FixedPoint &map, int axis, double center) {
  return on_axis<double>(axis, center, [&](const double *x, double *found) { map.find_quanta(x, 3, found); });
}
inline double place_of(const hg::FixedPoint &map, int axis, double center) {
  return on_axis<double>(axis, center, [&](const double *x, double *found) { map.find_place(x, 3, found); });
}
inline int32_t coordinate_of(const hg::FixedPoint &map, int axis, double center) {
  return on_axis<int32_t>(axis, center, [&](const double *x, int32_t *found) { map.find_coordinates(x, 3, found); });
}

// Coordinates are rounded down, after an error of rounding, or of wrapping where the axis is periodic
// (docs/theory/exactness.md).
inline mpq_class place_slack(const hg::Domain &domain, int axis) {
  return domain.periodic[axis] ? mpq_class(3, 8) : mpq_class(1, 1 << 20);
}

// By how many quanta the coordinate is below the centre; on periodic axes modulo the box, from -slack on.
inline mpq_class place_error(const hg::FixedPoint &map, const hg::Domain &domain, int axis, double center,
                             int32_t coordinate, const mpq_class &slack) {
  const mpq_class scale(map.scale);
  if (!domain.periodic[axis]) return (mpq_class(center) - 2 * mpq_class(map.half_origin[axis])) * scale - coordinate;
  const mpq_class low(domain.box_min[axis]), length = (mpq_class(domain.box_max[axis]) - low) * scale;
  const mpq_class error = (mpq_class(center) - low) * scale - coordinate;
  return error - floor_of((error + slack) / length) * length;
}

inline bool is_floor(const mpq_class &error, const mpq_class &slack) { return error >= -slack && error <= 1 + slack; }

// Throws unless the coordinate is that of the centre.
inline void require_place(const hg::FixedPoint &map, const hg::Domain &domain, int axis, double center,
                          int32_t coordinate) {
  const mpq_class slack = place_slack(domain, axis), error = place_error(map, domain, axis, center, coordinate, slack);
  require(is_floor(error, slack), "axis %d%s: %a is %g quanta from its coordinate %d", axis,
          domain.periodic[axis] ? " (periodic)" : "", center, error.get_d(), coordinate);
}

}  // namespace hgtest
