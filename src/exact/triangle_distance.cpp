// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/exact/triangle_distance.hpp"

#include "src/base/arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hg {
namespace {

// A point that is so many times farther out needs a scale of its own.
constexpr double kFarPoint = 0x1p400;

// Takes numbers of that size to some below 1.
double scale_of(double size) { return size > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(size), -1000, 1020) - 2) : 1; }

double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double length_of(const double *a) { return std::sqrt(dot(a, a)); }

// a -= b * factor
void subtract(double *a, const double *b, double factor) {
  for (int axis = 0; axis < 3; axis++) a[axis] -= b[axis] * factor;
}

// From (x, y) to the segment from (x0, y0) to (x1, y1), squared.
double square_to_segment(double x, double y, double x0, double y0, double x1, double y1) {
  const double dx = x1 - x0, dy = y1 - y0, length2 = dx * dx + dy * dy;
  const double along = (x - x0) * dx + (y - y0) * dy;
  const double t = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0.0;
  const double rest_x = x - (x0 + t * dx), rest_y = y - (y0 + t * dy);
  return rest_x * rest_x + rest_y * rest_y;
}

}  // namespace

Triangle::Triangle(const double *corners) {
  for (int k = 0; k < 9; k++) size_ = std::max(size_, std::fabs(corners[k]));
  scale_ = scale_of(size_);
  double edge[3][3], length[3];
  for (int k = 0; k < 3; k++) {
    for (int axis = 0; axis < 3; axis++) {
      edge[k][axis] = corners[3 * ((k + 1) % 3) + axis] * scale_ - corners[3 * k + axis] * scale_;
    }
    length[k] = length_of(edge[k]);
  }
  const auto longest = static_cast<int>(std::max_element(length, length + 3) - length);
  std::copy_n(corners + ptrdiff_t{3} * longest, 3, origin_);
  length_ = length[longest];
  if (!(length_ > 0)) return;  // a point

  double apex[3];
  for (int axis = 0; axis < 3; axis++) {
    axis_[0][axis] = edge[longest][axis] / length_;
    apex[axis] = -edge[(longest + 2) % 3][axis];
  }
  const double along = dot(apex, axis_[0]);
  apex_along_ = std::clamp(along, 0.0, length_);
  subtract(apex, axis_[0], along);
  apex_across_ = length_of(apex);
  // Of a needle rounding leaves any direction, not even across; but then it matters little.
  for (int axis = 0; axis < 3 && apex_across_ > 0; axis++) axis_[1][axis] = apex[axis] / apex_across_;
}

double Triangle::distance(const double *point) const {
  const double size = std::max(std::max(std::fabs(point[0]), std::fabs(point[1])), std::fabs(point[2]));
  const double scale = size <= size_ * kFarPoint ? scale_ : scale_of(size);
  double rest[3];
  for (int axis = 0; axis < 3; axis++) rest[axis] = point[axis] * scale - origin_[axis] * scale;
  const double along = dot(rest, axis_[0]);
  subtract(rest, axis_[0], along);
  const double across = dot(rest, axis_[1]);
  subtract(rest, axis_[1], across);
  return std::sqrt(dot(rest, rest) + square_in_plane(along, across, scale / scale_)) / scale;
}

double Triangle::square_in_plane(double along, double across, double ratio) const {
  const double length = length_ * ratio, apex_along = apex_along_ * ratio, apex_across = apex_across_ * ratio;
  if (across >= 0 && along >= 0 && along <= length && across * apex_along <= along * apex_across &&
      across * (length - apex_along) <= (length - along) * apex_across) {
    return 0;
  }
  return std::min(square_to_segment(along, across, 0, 0, length, 0),
                  std::min(square_to_segment(along, across, 0, 0, apex_along, apex_across),
                           square_to_segment(along, across, apex_along, apex_across, length, 0)));
}

}  // namespace hg
