// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/exact/overlap.hpp"

#include "src/exact/exact_sign.hpp"

#include <cfloat>
#include <cmath>
#include <functional>

namespace hg {
namespace {

// With u = 2^-53, dx*dx + dy*dy + dz*dz and s*s carry relative errors below 6u each; 2^-48 = 32u also covers a rounding
// mode other than to nearest. docs/theory/exactness.md, section 10.
constexpr double kRelativeError = 0x1p-48;
// A difference across a shift is off by less than 6u (|xa - xb| + the sizes of what is added).
constexpr double kWrapError = 0x1p-50;
// Between these, no square that matters loses bits to underflow or overflows.
constexpr double kSafeSquareMin = 1e-280, kSafeSquareMax = 1e300;

// A difference on one axis, of particles as far outside the box as they may be, is off by less than that many lengths.
constexpr double kBoxError = 0x1p-28;

// The order of shifts: by x, then y, then z.
bool is_backward(const Shift &shift) {
  for (const int32_t n : shift.n) {
    if (n != 0) return n < 0;
  }
  return false;
}

}  // namespace

void Overlap::set_domain(const Domain &domain) {
  domain_ = domain;
  short_ = find_short_vectors(domain);
  rounding_ = 0;
  for (int axis = 0; axis < domain.dimension; axis++) rounding_ += kBoxError * domain.period(axis);
}

bool Overlap::is_pair(const Ball &a, const Ball &b, const Shift &shift, int64_t &exact) const {
  return holds(a, b, shift, exact) && !comes_second(a, b, shift, exact);
}

bool Overlap::holds(const Ball &a, const Ball &b, const Shift &shift, int64_t &exact) const {
  double d2 = 0, wrap_error = 0;
  for (int axis = 0; axis < domain_.dimension; axis++) {
    double d = a.center[axis] - b.center[axis];
    if (const double size = domain_.shift_size(axis, shift); size > 0) {
      const double error = kWrapError * (std::fabs(d) + size);
      d = d + domain_.shifted(axis, shift);
      wrap_error += error * (2 * std::fabs(d) + error);
    }
    d2 = axis == 0 ? d * d : d2 + d * d;
  }
  const double s = interaction_.reach(a.radius, b.radius);
  const double s2 = s * s;
  if (accuracy_ == HG_DOUBLE) return d2 < s2 || (interaction_.touching && d2 == s2);
  if (s2 >= kSafeSquareMin && s2 <= kSafeSquareMax) {
    const double band = kRelativeError * (d2 + s2) + wrap_error;
    if (d2 + band < s2) return true;
    if (wrap_error <= DBL_MAX && !(d2 - band < s2)) return false;  // also where d2 overflowed
    if (accuracy_ == HG_FLOAT) return true;
  }
  exact++;
  return holds_exactly(a, b, shift);
}

bool Overlap::holds_exactly(const Ball &a, const Ball &b, const Shift &shift) const {
  ExactSum difference[3], reach;
  for (int axis = 0; axis < domain_.dimension; axis++) {
    difference[axis].add(a.center[axis], 1);
    difference[axis].add(b.center[axis], -1);
    add_shift(difference[axis], domain_, axis, shift);
  }
  interaction_.add_reach(reach, a.radius, b.radius);
  return exact_order(difference, domain_.dimension, reach) < (interaction_.touching ? 1 : 0);
}

// In a cell that is just not too short, two images may both touch, or seem to, as doubles round: then the pair is that
// with the smaller shift of the later particle.
bool Overlap::comes_second(const Ball &a, const Ball &b, const Shift &shift, int64_t &exact) const {
  if (domain_.all_images || (accuracy_ != HG_DOUBLE && !interaction_.touching)) return false;
  const double reach = interaction_.reach(a.radius, b.radius);
  if (!(2 * reach * (1 + 0x1p-20) + rounding_ >= short_.shortest)) return false;
  for (int k = 0; k < 2 * short_.count; k++) {
    const Shift step = k % 2 == 0 ? short_.shift[k / 2] : Shift{} - short_.shift[k / 2];
    const bool a_is_later = std::less<>{}(b.center, a.center);
    if (is_backward(step) == a_is_later && holds(a, b, shift + step, exact)) return true;
  }
  return false;
}

}  // namespace hg
