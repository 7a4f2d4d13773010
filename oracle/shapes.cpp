// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/shapes.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace oracle {
namespace {

mpz_class floor_of(const mpq_class &x) {
  mpz_class whole;
  mpz_fdiv_q(whole.get_mpz_t(), x.get_num().get_mpz_t(), x.get_den().get_mpz_t());
  return whole;
}

// From y to the interval.
mpq_class gap(const mpq_class &y, double low, double high) {
  if (std::isfinite(low) && y < mpq_class(low)) return mpq_class(low) - y;
  if (std::isfinite(high) && y > mpq_class(high)) return y - mpq_class(high);
  return 0;
}

// Of all images on a periodic axis only the last one below the box and the first one not below it can be nearest.
mpq_class least_gap(const hg_grid_def &def, int axis, double x, double low, double high) {
  if (def.periodic[axis] == 0) return gap(mpq_class(x), low, high);
  if (!std::isfinite(low) || !std::isfinite(high)) return 0;
  const mpq_class length = mpq_class(def.box_max[axis]) - mpq_class(def.box_min[axis]);
  const mpq_class images(floor_of((mpq_class(low) - mpq_class(x)) / length));
  const mpq_class below = mpq_class(x) + images * length;
  return std::min(gap(below, low, high), gap(below + length, low, high));
}

struct Vector {
  mpq_class x[3];
};

Vector operator-(const Vector &a, const Vector &b) { return {{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}}; }
mpq_class dot(const Vector &a, const Vector &b) { return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2]; }
Vector cross(const Vector &a, const Vector &b) {
  return {{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2], a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}

mpq_class square_to_segment(const Vector &p, const Vector &a, const Vector &b) {
  const Vector edge = b - a, offset = p - a;
  const mpq_class length2 = dot(edge, edge);
  mpq_class t = length2 == 0 ? mpq_class(0) : mpq_class(dot(offset, edge) / length2);
  t = std::max(mpq_class(0), std::min(mpq_class(1), t));
  Vector rest = offset;
  for (int axis = 0; axis < 3; axis++) rest.x[axis] -= t * edge.x[axis];
  return dot(rest, rest);
}

// The plane counts if the foot of p lies inside, on the same side of all edges; else an edge is nearest.
mpq_class square_to_triangle(const Vector &p, const Vector *corner) {
  const Vector normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
  const mpq_class area2 = dot(normal, normal);
  bool inside = area2 != 0;
  mpq_class least = -1;
  for (int k = 0; k < 3; k++) {
    const Vector &a = corner[k], &b = corner[(k + 1) % 3];
    inside = inside && dot(cross(b - a, p - a), normal) >= 0;
    const mpq_class square = square_to_segment(p, a, b);
    if (least < 0 || square < least) least = square;
  }
  if (!inside) return least;
  const mpq_class height = dot(p - corner[0], normal);
  return height * height / area2;
}

// The images of a coordinate that lie between two bounds.
std::vector<mpq_class> images_within(const hg_grid_def &def, int axis, double x, const mpq_class &low,
                                     const mpq_class &high) {
  if (def.periodic[axis] == 0) return {mpq_class(x)};
  const mpq_class length = mpq_class(def.box_max[axis]) - mpq_class(def.box_min[axis]);
  std::vector<mpq_class> images;
  mpq_class image = mpq_class(x) + mpq_class(floor_of((low - mpq_class(x)) / length)) * length;
  for (; image <= high; image += length) {
    if (image >= low) images.push_back(image);
  }
  return images;
}

}  // namespace

Meeting triangle_meeting(const hg_grid_def &def, const double *corners, const Sphere &particle, double tolerance) {
  Vector corner[3];
  for (int k = 0; k < 9; k++) corner[k / 3].x[k % 3] = corners[k];
  const mpq_class reach = mpq_class(particle.radius) + mpq_class(def.margin), beyond = reach + mpq_class(tolerance);
  std::vector<mpq_class> images[3];
  for (int axis = 0; axis < 3; axis++) {
    const auto [low, high] = std::minmax({corners[axis], corners[3 + axis], corners[6 + axis]});
    images[axis] = images_within(def, axis, particle.center[axis], mpq_class(low) - beyond, mpq_class(high) + beyond);
  }
  Meeting nearest = Meeting::kNone;
  for (const mpq_class &x : images[0]) {
    for (const mpq_class &y : images[1]) {
      for (const mpq_class &z : images[2]) {
        const mpq_class square = square_to_triangle({{x, y, z}}, corner);
        const int order = cmp(square, reach * reach);
        const Meeting meeting = order < 0    ? Meeting::kMeeting
                                : order == 0 ? Meeting::kTouching
                                             : (square <= beyond * beyond ? Meeting::kNearly : Meeting::kNone);
        nearest = std::max(nearest, meeting);
      }
    }
  }
  return nearest;
}

bool box_meets(const hg_grid_def &def, const double *low, const double *high, const Sphere &particle) {
  mpq_class distance2 = 0, reach = mpq_class(particle.radius) + mpq_class(def.margin);
  for (int axis = 0; axis < def.dimension; axis++) {
    if (low[axis] == HUGE_VAL || high[axis] == -HUGE_VAL) return false;
    const mpq_class d = least_gap(def, axis, particle.center[axis], low[axis], high[axis]);
    distance2 += d * d;
  }
  const int order = cmp(distance2, reach * reach);
  return distance2 == 0 || order < 0 || (order == 0 && def.touching != 0);
}

}  // namespace oracle
