// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/exact/overlap.hpp"

#include "src/exact/exact_sign.hpp"

#include <cfloat>
#include <cmath>
#include <cstring>

static_assert(FLT_EVAL_METHOD == 0, "HG_DOUBLE is defined by double arithmetic without extended precision");

namespace hg {
namespace {

// With u = 2^-53, dx*dx + dy*dy + dz*dz and s*s carry relative errors below 6u each; 2^-48 = 32u also covers a rounding
// mode other than to nearest.
constexpr double kRelativeError = 0x1p-48;
// A difference across n box lengths is off by less than 2^-51 (|xa - xb| + |n| length), see docs/exactness.md.
constexpr double kWrapError = 0x1p-50;
// Between these, no square that matters loses bits to underflow or overflows.
constexpr double kSafeSquareMin = 1e-280, kSafeSquareMax = 1e300;

// Compares bits: a host that takes subnormals for zero must not change the answer.
double larger_radius(double a, double b) {
  int64_t bits_a = 0, bits_b = 0;
  std::memcpy(&bits_a, &a, sizeof a);
  std::memcpy(&bits_b, &b, sizeof b);
  return bits_a > bits_b ? a : b;
}

}  // namespace

bool Overlap::test(const Ball &a, const Ball &b, Image image, int64_t &exact) const {
  const int dimension = domain_.dimension;
  double boxes[3] = {0, 0, 0};  // how many box lengths to add to a - b
  double d2 = 0, wrap_error = 0;
  for (int k = 0; k < dimension; k++) {
    double d = a.center[k] - b.center[k];
    if (domain_.periodic[k]) {
      boxes[k] = image_step(image, k) + domain_.wraps(k, b.center[k]) - domain_.wraps(k, a.center[k]);
      if (boxes[k] != 0) {
        const double shift = boxes[k] * domain_.length[k];
        const double error = kWrapError * (std::fabs(d) + std::fabs(shift));
        d = d + shift;
        wrap_error += error * (2 * std::fabs(d) + error);
      }
    }
    d2 = k == 0 ? d * d : d2 + d * d;
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
  return test_exactly(a, b, boxes);
}

bool Overlap::test_exactly(const Ball &a, const Ball &b, const double *boxes) const {
  ExactSum difference[3], reach;
  for (int k = 0; k < domain_.dimension; k++) {
    difference[k].add(a.center[k], 1);
    difference[k].add(b.center[k], -1);
    const auto factor = static_cast<int64_t>(boxes[k]);
    if (factor != 0) {
      difference[k].add(domain_.box_max[k], factor);
      difference[k].add(domain_.box_min[k], -factor);
    }
  }
  if (interaction_.kind == HG_CONTACT) {
    reach.add(a.radius, 1);
    reach.add(b.radius, 1);
  } else {
    reach.add(larger_radius(a.radius, b.radius), 1);
  }
  reach.add(interaction_.margin, 1);
  return exact_less(difference, domain_.dimension, reach);
}

}  // namespace hg
