// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether two particles interact, decided in rational numbers.
#include "oracle/rule.hpp"

#include <gmpxx.h>

#include <cmath>

namespace oracle {
namespace {

// n + 1/2 rounds to n + 1; both images are equally near, so it is of no matter.
mpz_class nearest_integer(const mpq_class &x) {
  const mpq_class shifted = x + mpq_class(1, 2);
  mpz_class quotient;
  mpz_fdiv_q(quotient.get_mpz_t(), shifted.get_num_mpz_t(), shifted.get_den_mpz_t());
  return quotient;
}

mpq_class exact_squared_distance(const hg_grid_def &def, const double *a, const double *b) {
  mpq_class sum = 0;
  for (int axis = 0; axis < def.dimension; axis++) {
    mpq_class d = mpq_class(a[axis]) - mpq_class(b[axis]);
    if (def.periodic[axis] != 0) {
      const mpq_class length = mpq_class(def.box_max[axis]) - mpq_class(def.box_min[axis]);
      d -= nearest_integer(d / length) * length;
    }
    sum += d * d;
  }
  return sum;
}

mpq_class exact_squared_reach(const hg_grid_def &def, double ra, double rb) {
  mpq_class reach(def.margin);
  if (def.interaction == HG_MAX_RANGE) {
    reach += mpq_class(std::fmax(ra, rb));
  } else {
    reach += mpq_class(ra) + mpq_class(rb);
  }
  return reach * reach;
}

enum class Verdict { kYes, kNo, kUnclear };

// Doubles decide where the two squares differ by far more than rounding can do. Per axis the folded difference is
// wrong by at most E = 16 eps (|dx| + L): rounding dx, L, n L and the last subtraction costs less than 4 eps
// (|dx| + L), and a wrong n where two images are equally near costs as much again. So the square of the distance is
// wrong by sum (2 |d| E + E^2) plus a few eps of itself; the bound used is larger by orders of magnitude. Squares
// outside [1e-280, 1e280] are left to the rationals, which keeps under- and overflow out of the argument.
Verdict clear_verdict(const hg_grid_def &def, const Sphere &a, const Sphere &b) {
  constexpr double kFold = 16 * 0x1p-53;
  double distance2 = 0;
  double slack = 0;
  for (int axis = 0; axis < def.dimension; axis++) {
    double d = a.center[axis] - b.center[axis];
    if (def.periodic[axis] != 0) {
      const double length = def.box_max[axis] - def.box_min[axis];
      const double error = kFold * (std::fabs(d) + length);
      d -= std::nearbyint(d / length) * length;
      slack += 2 * std::fabs(d) * error + error * error;
    }
    distance2 += d * d;
  }
  const double base = def.interaction == HG_MAX_RANGE ? std::fmax(a.radius, b.radius) : a.radius + b.radius;
  const double reach2 = (base + def.margin) * (base + def.margin);
  const auto in_range = [](double x) { return x > 1e-280 && x < 1e280; };
  if (!in_range(distance2) || !in_range(reach2) || !(slack < 1e280)) return Verdict::kUnclear;
  slack = 2 * slack + 1e-12 * (distance2 + reach2);
  if (distance2 + slack < reach2) return Verdict::kYes;
  if (distance2 - slack > reach2) return Verdict::kNo;
  return Verdict::kUnclear;
}

}  // namespace

bool exact_interact(const hg_grid_def &def, const Sphere &a, const Sphere &b) {
  const Verdict verdict = clear_verdict(def, a, b);
  if (verdict != Verdict::kUnclear) return verdict == Verdict::kYes;
  return exact_squared_distance(def, a.center, b.center) < exact_squared_reach(def, a.radius, b.radius);
}

double relative_gap(const hg_grid_def &def, const Sphere &a, const Sphere &b) {
  const mpq_class ratio =
      exact_squared_distance(def, a.center, b.center) / exact_squared_reach(def, a.radius, b.radius);
  return std::sqrt(ratio.get_d()) - 1;
}

}  // namespace oracle
