// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a centre lies in quanta, in rational numbers: what fixed-point coordinates are held against.
#pragma once

#include "src/space/fixed_point.hpp"
#include "tests/unit/cells.hpp"
#include "tests/unit/checks.hpp"

#include <gmpxx.h>

#include <array>

namespace hgtest {

inline mpz_class floor_of(const mpq_class &x) {
  mpz_class quotient;
  mpz_fdiv_q(quotient.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  return quotient;
}

// Coordinates are rounded down, after an error of rounding, or of wrapping where the axis is periodic
// (docs/theory/exactness.md).
inline mpq_class place_slack(const hg::Domain &domain, int axis) {
  return domain.periodic[axis] ? mpq_class(3, 8) : mpq_class(1, 1 << 20);
}

// By how many quanta a place is below the centre on each axis; on periodic axes but for whole edges of the cell, which
// leave -slack or more.
template <class Number>
std::array<mpq_class, 3> place_errors(const hg::FixedPoint &map, const hg::Domain &domain, const double *center,
                                      const Number *place, const mpq_class &slack) {
  const mpq_class scale(map.scale);
  std::array<mpq_class, 3> error;
  for (int axis = 0; axis < domain.dimension; axis++) {
    const mpq_class low = 2 * mpq_class(map.half_origin[axis]) + mpq_class(map.box_min[axis]);
    error[axis] = (mpq_class(center[axis]) - low) * scale - mpq_class(place[axis]);
  }
  for (int edge = domain.dimension - 1; edge >= 0; edge--) {
    if (!domain.periodic[edge]) continue;
    const mpz_class edges = floor_of((error[edge] + slack) / (exact_edge(domain, edge, edge) * scale));
    for (int axis = 0; axis <= edge; axis++) error[axis] -= edges * exact_edge(domain, edge, axis) * scale;
  }
  return error;
}

inline bool is_floor(const mpq_class &error, const mpq_class &slack) { return error >= -slack && error <= 1 + slack; }

// Throws unless the coordinates are those of the centre.
inline void require_place(const hg::FixedPoint &map, const hg::Domain &domain, const double *center,
                          const int32_t *coordinate) {
  const auto errors = place_errors(map, domain, center, coordinate, mpq_class(3, 8));
  for (int axis = 0; axis < domain.dimension; axis++) {
    require(is_floor(errors[axis], place_slack(domain, axis)), "axis %d%s: %a is %g quanta from its coordinate %d",
            axis, domain.periodic[axis] ? " (periodic)" : "", center[axis], errors[axis].get_d(), coordinate[axis]);
  }
}

}  // namespace hgtest
