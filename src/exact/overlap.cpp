// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/exact/overlap.hpp"

#include "src/exact/exact_sign.hpp"

#include <cfloat>
#include <cmath>

static_assert(FLT_EVAL_METHOD == 0, "HG_DOUBLE is defined by double arithmetic without extended precision");

namespace hg {
namespace {

// With u = 2^-53, dx*dx + dy*dy + dz*dz and s*s carry relative errors below 6u each; 2^-48 = 32u also covers a rounding
// mode other than to nearest. docs/theory/exactness.md, section 10.
constexpr double kRelativeError = 0x1p-48;
// A difference across n box lengths is off by less than 2^-51 (|xa - xb| + |n| length).
constexpr double kWrapError = 0x1p-50;
// Between these, no square that matters loses bits to underflow or overflows.
constexpr double kSafeSquareMin = 1e-280, kSafeSquareMax = 1e300;

}  // namespace

bool Overlap::holds(const Ball &a, const Ball &b, Image image, int64_t &exact) const {
  double boxes[3] = {0, 0, 0};  // how many box lengths to add to a - b
  double d2 = 0, wrap_error = 0;
  for (int axis = 0; axis < domain_.dimension; axis++) {
    double d = a.center[axis] - b.center[axis];
    if (domain_.periodic[axis]) {
      boxes[axis] = image_step(image, axis) + domain_.wraps(axis, b.center[axis]) - domain_.wraps(axis, a.center[axis]);
      if (boxes[axis] != 0) {
        const double shift = boxes[axis] * domain_.length[axis];
        const double error = kWrapError * (std::fabs(d) + std::fabs(shift));
        d = d + shift;
        wrap_error += error * (2 * std::fabs(d) + error);
      }
    }
    d2 = axis == 0 ? d * d : d2 + d * d;
  }
  const double s = interaction_.reach(a.radius, b.radius);
  const double s2 = s * s;
  if (accuracy_ == HG_DOUBLE) return d2 < s2;
  if (s2 >= kSafeSquareMin && s2 <= kSafeSquareMax) {
    const double band = kRelativeError * (d2 + s2) + wrap_error;
    if (d2 + band < s2) return true;
    if (wrap_error <= DBL_MAX && !(d2 - band < s2)) return false;  // also where d2 overflowed
    if (accuracy_ == HG_FLOAT) return true;
  }
  exact++;
  return holds_exactly(a, b, boxes);
}

bool Overlap::holds_exactly(const Ball &a, const Ball &b, const double *boxes) const {
  ExactSum difference[3], reach;
  for (int axis = 0; axis < domain_.dimension; axis++) {
    difference[axis].add(a.center[axis], 1);
    difference[axis].add(b.center[axis], -1);
    const auto factor = static_cast<int64_t>(boxes[axis]);
    if (factor != 0) {
      difference[axis].add(domain_.box_max[axis], factor);
      difference[axis].add(domain_.box_min[axis], -factor);
    }
  }
  interaction_.add_reach(reach, a.radius, b.radius);
  return exact_less(difference, domain_.dimension, reach);
}

}  // namespace hg
