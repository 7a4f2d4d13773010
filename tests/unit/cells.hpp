// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Periodic cells of any edges for tests, and whole numbers of their edges in rational numbers.
#pragma once

#include "src/exact/exact_sign.hpp"
#include "tests/support/rng.hpp"
#include "tests/unit/domains.hpp"

#include <gmpxx.h>

#include <cmath>

namespace hgtest {

inline constexpr int kTiltedAxes[3][2] = {{1, 0}, {2, 0}, {2, 1}};  // the higher first

// Some of the tilts that the periodic axes of a domain allow, each up to so many lengths.
template <class Any>
void tilt_some(Rng &rng, hg::Domain &domain, Any &&any) {
  for (const auto &[higher, lower] : kTiltedAxes) {
    if (!domain.periodic[higher] || !domain.periodic[lower] || rng.chance(0.2)) continue;
    set_tilt(domain, higher, lower, any(domain.length[lower]));
  }
}

// Of few whole lengths, so that many vectors are as long as others.
inline hg::Domain whole_cell(Rng &rng, int dimension) {
  hg::Domain domain = open_space(dimension);
  const double unit = std::ldexp(1.0, rng.integer(-40, 40));
  const int longest = rng.chance(0.7) ? 6 : 300;
  for (int axis = 0; axis < dimension; axis++) {
    const int low = rng.integer(-9, 9);
    set_box(domain, axis, unit * low, unit * (low + rng.integer(1, longest)), rng.chance(0.85));
  }
  tilt_some(rng, domain, [&](double length) { return rng.integer(-4, 4) * length + unit * rng.integer(0, longest); });
  return domain;
}

// Of lengths that doubles round, one up to 1000 times longer than another, and tilts of several lengths.
inline hg::Domain real_cell(Rng &rng, int dimension) {
  hg::Domain domain = open_space(dimension);
  const double unit = std::pow(10, rng.uniform(-9, 9)), thin = rng.chance(0.5) ? 0.3 : 3;
  for (int axis = 0; axis < dimension; axis++) {
    const double low = unit * rng.uniform(-10, 10), length = unit * std::pow(10, -thin * rng.uniform());
    set_box(domain, axis, low, low + length, rng.chance(0.85));
  }
  tilt_some(rng, domain, [&](double length) { return length * (rng.chance(0.5) ? 1 : 8) * rng.uniform(-1, 1); });
  return domain;
}

inline hg::Domain any_cell(Rng &rng) {
  const int dimension = rng.integer(2, 3);
  return rng.chance(0.5) ? whole_cell(rng, dimension) : real_cell(rng, dimension);
}

// In the box, or box lengths away along its periodic axes, up to as many as are allowed.
inline void any_center(Rng &rng, const hg::Domain &domain, double *center) {
  int most = 1 << rng.integer(0, 20);
  do {
    for (int axis = 0; axis < domain.dimension; axis++) {
      const int boxes = domain.periodic[axis] && rng.chance(0.7) ? rng.integer(-most, most) : 0;
      const double place = rng.chance(0.1) ? rng.integer(0, 1) : rng.uniform();
      center[axis] = domain.box_min[axis] + (place + boxes) * domain.length[axis];
    }
    most /= 2;
  } while (domain.outside(center).boxes > domain.most_outside());
}

// A few of each periodic edge.
inline hg::Shift any_shift(Rng &rng, const hg::Domain &domain, int most) {
  hg::Shift shift;
  for (int axis = 0; axis < domain.dimension; axis++) {
    if (domain.periodic[axis]) shift.n[axis] = rng.integer(-most, most);
  }
  return shift;
}

// Of the edge of an axis, what it moves on an axis.
inline mpq_class exact_edge(const hg::Domain &domain, int edge, int axis) {
  if (!domain.periodic[edge] || axis > edge) return 0;
  if (axis < edge) return mpq_class(domain.tilt[hg::kTiltOf[edge][axis]]);
  return mpq_class(domain.box_max[axis]) - mpq_class(domain.box_min[axis]);
}

inline mpq_class exact_shift(const hg::Domain &domain, int axis, const hg::Shift &shift) {
  mpq_class sum = 0;
  for (int edge = axis; edge < domain.dimension; edge++) sum += shift.n[edge] * exact_edge(domain, edge, axis);
  return sum;
}

// Calls visit(shift) for each by which edges move by no more than `most` on every axis, and for some more. Ascending by
// c, then b, then a.
template <class Visit>
void visit_near(const hg::Domain &domain, const double *most, const Visit &visit, int axis = 2,
                const hg::Shift &taken = {}) {
  if (axis < 0) {
    visit(taken);
    return;
  }
  hg::Shift shift = taken;
  int32_t last = 0;
  if (axis < domain.dimension && domain.periodic[axis]) {
    const double edge = domain.length[axis], moved = exact_shift(domain, axis, taken).get_d();
    shift.n[axis] = static_cast<int32_t>(std::floor((-most[axis] - moved) / edge));
    last = static_cast<int32_t>(std::ceil((most[axis] - moved) / edge));
  }
  for (; shift.n[axis] <= last; shift.n[axis]++) visit_near(domain, most, visit, axis - 1, shift);
}

inline mpq_class exact_square(const hg::Domain &domain, const hg::Shift &shift) {
  mpq_class sum = 0;
  for (int axis = 0; axis < domain.dimension; axis++) {
    const mpq_class x = exact_shift(domain, axis, shift);
    sum += x * x;
  }
  return sum;
}

inline mpq_class exact_value(const hg::ExactSum &sum) {
  mpq_class value = 0;
  for (int k = 0; k < sum.count; k++) value += mpq_class(sum.terms[k].value) * static_cast<double>(sum.terms[k].factor);
  return value;
}

inline bool same_shift(const hg::Shift &s, const hg::Shift &t) { return (s - t).is_none(); }

}  // namespace hgtest
