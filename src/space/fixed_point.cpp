// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/space/fixed_point.hpp"

#include <algorithm>
#include <cmath>

namespace hg {

namespace {

double largest_half_extent(const Bounds &bounds, int dimension) {
  double half = 0;
  for (int axis = 0; axis < dimension; axis++) {
    half = std::max(half, 0.5 * bounds.max[axis] - 0.5 * bounds.min[axis]);
  }
  return half;
}

// The greatest power of two that makes 2 * half shorter than 2^bits, within what doubles can scale by.
double scale_for(double half, int bits) {
  if (!(half > 0)) return 1;
  int exponent = 0;
  std::frexp(half, &exponent);  // half < 2^exponent
  return std::ldexp(1.0, std::clamp(bits - 1 - exponent, -1020, 1000));
}

}  // namespace

FixedPoint FixedPoint::over(const Bounds &bounds, const Domain &domain, double least_extent) {
  FixedPoint map;
  map.scale = scale_for(std::max(0.5 * least_extent, largest_half_extent(bounds, domain.dimension)), 30);
  map.set_axes(bounds, domain);
  return map;
}

FixedPoint FixedPoint::wrapping(const Bounds &bounds, const Domain &domain, double largest, double most_wraps) {
  FixedPoint map;
  map.scale = std::min(scale_for(0.5 * largest, 26), scale_for(largest_half_extent(bounds, domain.dimension), 46));
  for (int axis = 0; axis < domain.dimension; axis++) {
    // Wrapping errs by 3 (most_wraps + 1) 2^-53 lengths, which shall be less than 3/8 of a quantum.
    if (domain.periodic[axis]) {
      map.scale = std::min(map.scale, scale_for(0.5 * domain.length[axis] * (most_wraps + 1), 50));
    }
  }
  map.set_axes(bounds, domain);
  return map;
}

void FixedPoint::set_axes(const Bounds &bounds, const Domain &domain) {
  for (int axis = 0; axis < domain.dimension; axis++) {
    half_origin[axis] = 0.5 * bounds.min[axis];
    extent[axis] = (0.5 * bounds.max[axis] - half_origin[axis]) * (2 * scale);
    if (domain.periodic[axis]) box_min[axis] = domain.box_min[axis];
  }
  set_cell(domain);
}

void FixedPoint::set_cell(const Domain &domain) {
  for (int axis = 0; axis < domain.dimension; axis++) {
    length[axis] = domain.period(axis);
    period[axis] = low_word(period_place(axis));
  }
  for (int k = 0; k < 3; k++) tilt[k] = domain.tilt[k];
  tilted = domain.is_tilted();
}

}  // namespace hg
