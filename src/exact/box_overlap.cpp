// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/exact/box_overlap.hpp"

#include "src/base/ordered_bits.hpp"
#include "src/exact/exact_sign.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace hg {
namespace {

// As in overlap.cpp: of squares, and where no square loses bits.
constexpr double kRelativeError = 0x1p-48;
constexpr double kSafeSquareMin = 1e-280, kSafeSquareMax = 1e300;
// Of a gap across periodic faces, relative to all that it is made of. Two images that seem equally near are so within
// this, too.
constexpr double kGapError = 0x1p-48;
// Of a reach and a gap, which are rounded.
constexpr double kRounded = 1 + 0x1p-40;

bool lies_in(const AlignedBox &box, const double *center, int axis) {
  const int64_t x = order_of(center[axis]);
  return order_of(box.low[axis]) <= x && x <= order_of(box.high[axis]);
}

}  // namespace

bool BoxOverlap::holds(const AlignedBox &box, const Ball &ball) const {
  const double reach = ball.radius + margin_;
  double d2 = 0, error2 = 0;
  bool inside = true;
  for (int axis = 0; axis < domain_.dimension; axis++) {
    if (box.covers(domain_, axis)) continue;
    double x = ball.center[axis], error = 0;
    if (domain_.periodic[axis]) {
      const double moved = static_cast<double>(nearest_image(box, ball, axis)) * domain_.length[axis];
      error = kGapError * (std::fabs(box.low[axis]) + std::fabs(box.high[axis]) + std::fabs(x) + std::fabs(moved) +
                           domain_.length[axis]);
      x += moved;
    }
    const double below = box.low[axis] - x, above = x - box.high[axis], d = std::max(std::max(below, above), 0.0);
    if (d - error > reach * kRounded) return false;
    inside = inside && (domain_.periodic[axis] ? below <= -error && above <= -error : lies_in(box, ball.center, axis));
    error2 += error * (2 * d + error);
    d2 += d * d;
  }
  if (inside) return true;
  const double reach2 = reach * reach;
  if (reach2 >= kSafeSquareMin && reach2 <= kSafeSquareMax) {
    const double band = kRelativeError * (d2 + reach2) + error2;
    if (d2 + band < reach2) return true;
    if (band <= DBL_MAX && !(d2 - band < reach2)) return false;
  }
  return holds_exactly(box, ball);
}

bool BoxOverlap::holds_exactly(const AlignedBox &box, const Ball &ball) const {
  ExactSum difference[3], reach;
  bool inside = true;
  for (int axis = 0; axis < domain_.dimension; axis++) {
    if (box.covers(domain_, axis)) continue;
    difference[axis] = nearest_gap(box, ball, axis);
    inside = inside && difference[axis].count == 0;
  }
  reach.add(ball.radius, 1);
  reach.add(margin_, 1);
  return inside || exact_order(difference, domain_.dimension, reach) < (touching_ ? 1 : 0);
}

// Doubles find the nearest image of the centre or one beside it: on this axis the box is shorter than two lengths, and
// neither it nor the particle lies more than 2^20 of them outside the cell.
ExactSum BoxOverlap::nearest_gap(const AlignedBox &box, const Ball &ball, int axis) const {
  if (!domain_.periodic[axis]) return gap(box, ball, axis, 0);
  const int64_t image = nearest_image(box, ball, axis);
  ExactSum nearest = gap(box, ball, axis, image);
  for (const int64_t beside : {image - 1, image + 1}) {
    const ExactSum other = gap(box, ball, axis, beside);
    if (exact_order(&other, 1, nearest) < 0) nearest = other;
  }
  return nearest;
}

int64_t BoxOverlap::nearest_image(const AlignedBox &box, const Ball &ball, int axis) const {
  const double middle = 0.5 * box.low[axis] + 0.5 * box.high[axis];
  return static_cast<int64_t>(std::floor((middle - ball.center[axis]) / domain_.length[axis] + 0.5));
}

// From the centre, moved by so many lengths, to the box: positive, or no terms.
ExactSum BoxOverlap::gap(const AlignedBox &box, const Ball &ball, int axis, int64_t image) const {
  const double edges[2] = {box.low[axis], box.high[axis]};
  for (int side = 0; side < 2; side++) {
    if (!std::isfinite(edges[side])) continue;
    const int64_t sign = side == 0 ? 1 : -1;
    ExactSum sum;
    sum.add(edges[side], sign);
    sum.add(ball.center[axis], -sign);
    if (image != 0) {
      sum.add(domain_.box_max[axis], -sign * image);
      sum.add(domain_.box_min[axis], sign * image);
    }
    if (round_exactly(sum) > 0) return sum;
  }
  return {};
}

}  // namespace hg
