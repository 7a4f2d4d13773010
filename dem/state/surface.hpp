// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The surfaces of walls, piece by piece: a plane, a cylinder or a triangle, and its point that is nearest to a
// particle.
#pragma once

#include "dem/base/vector.hpp"
#include "dem/setup/wall_body.hpp"

#include <hgrid/hgrid.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dem {

// Where a wall stands and how it moves: x goes to pivot + turn (x - origin), where the origin is the pivot at first.
template <int D>
struct WallPose {
  Eigen::Matrix<double, D, D, Eigen::DontAlign> turn = Eigen::Matrix<double, D, D>::Identity();
  Vec<D, double> origin = Vec<D, double>::Zero(), pivot = Vec<D, double>::Zero();
  Vec<D, double> velocity = Vec<D, double>::Zero();
  Spin<D, double> spin = Spin<D, double>::Zero();

  Vec<D, double> place(const Vec<D, double> &x) const { return pivot + turn * (x - origin); }
  Vec<D, double> direction(const Vec<D, double> &n) const { return turn * n; }
  Vec<D, double> velocity_at(const Vec<D, double> &x) const {
    return velocity + dem::turn<D, double>(spin, Vec<D, double>(x - pivot));
  }
};

// One piece of a wall where it stands now.
template <int D>
struct Surface {
  int32_t wall = 0;      // among the bodies
  uint8_t material = 0;  // one more than the last: none (materials)
  WallShape shape = WallShape::kPlane;
  double radius = 0;             // cylinder
  Vec<D, double> first;          // a point of the plane, of the axis; a corner
  Vec<D, double> second, third;  // second: the normal, the direction of the axis; both: corners
};

// The point of a triangle that is nearest to x, also of one that is a segment or a point: the foot of the perpendicular
// if that lies within, else the nearest of its edges.
inline Vec<3, double> nearest_on_segment(const Vec<3, double> &a, const Vec<3, double> &b, const Vec<3, double> &x) {
  const Vec<3, double> along = b - a;
  const double square = along.squaredNorm();
  const double share = square > 0 ? std::clamp((x - a).dot(along) / square, 0.0, 1.0) : 0;
  // Ends are met to the last bit, whichever end an edge starts from.
  return share < 1 ? Vec<3, double>(a + share * along) : b;
}

inline Vec<3, double> nearest_on_triangle(const Vec<3, double> &a, const Vec<3, double> &b, const Vec<3, double> &c,
                                          const Vec<3, double> &x) {
  const Vec<3, double> normal = (b - a).cross(c - a);
  const double square = normal.squaredNorm();
  if (square > 0) {
    // Areas of the three triangles with the foot, over that of the whole.
    const double of_a = (c - b).cross(x - b).dot(normal), of_b = (a - c).cross(x - c).dot(normal);
    const double of_c = (b - a).cross(x - a).dot(normal);
    if (of_a >= 0 && of_b >= 0 && of_c >= 0) return x - normal * (normal.dot(x - a) / square);
  }
  Vec<3, double> best = nearest_on_segment(a, b, x);
  for (const Vec<3, double> &other : {nearest_on_segment(b, c, x), nearest_on_segment(c, a, x)}) {
    if ((other - x).squaredNorm() < (best - x).squaredNorm()) best = other;
  }
  return best;
}

// The point of a surface that is nearest to a centre: `normal`, of length 1, points to it from there.
template <int D>
struct NearestPoint {
  Vec<D, double> normal;
  double distance;  // of a plane or cylinder negative if the centre is behind it
};

template <int D>
NearestPoint<D> nearest_point(const Surface<D> &surface, const Vec<D, double> &x) {
  if (surface.shape == WallShape::kPlane) {
    return {-surface.second, surface.second.dot(x - surface.first)};
  }
  if (surface.shape == WallShape::kCylinder) {
    Vec<D, double> out = x - surface.first;
    if constexpr (D == 3) out -= surface.second * surface.second.dot(out);
    Vec<D, double> normal;
    const double distance = normalize<D, double>(out, normal);  // on the axis any direction is as good
    return {normal, surface.radius - distance};
  }
  if constexpr (D == 3) {
    const Vec<3, double> to = nearest_on_triangle(surface.first, surface.second, surface.third, x) - x;
    Vec<3, double> normal;
    double distance = normalize<3, double>(to, normal);
    // A centre within the triangle is pushed to its outer side, to which the corners go round counterclockwise.
    if (distance == 0)
      normalize<3, double>((surface.third - surface.first).cross(surface.second - surface.first), normal);
    return {normal, distance};
  }
  return {Vec<D, double>::Zero(), 0};  // there are no meshes in two dimensions
}

// A surface within reach of a particle.
template <int D>
struct SurfaceTouch {
  size_t place;  // in the list
  NearestPoint<D> nearest;
  bool counts;
};

// Of the surfaces first .. last - 1 of a list, all of one particle, those within reach. Forces act where a surface is
// nearer than all of it around: at the local minima of the distance. A triangle's nearest point is one if no other
// triangle of its mesh that has this point, too, comes nearer; of points that several triangles share the first counts.
// So a flat floor is one contact wherever its triangles meet, an edge or a corner that sticks out is one, a groove two.
template <int D>
void find_touches(const std::vector<Surface<D>> &surfaces, const hg_pair *list, size_t first, size_t last,
                  const Vec<D, double> &x, double radius, double range, std::vector<SurfaceTouch<D>> &touches) {
  touches.clear();
  const auto surface_of = [&](const SurfaceTouch<D> &touch) -> const Surface<D> & {
    return surfaces[static_cast<size_t>(list[touch.place].b)];
  };
  for (size_t p = first; p < last; p++) {
    const NearestPoint<D> nearest = nearest_point<D>(surfaces[static_cast<size_t>(list[p].b)], x);
    if (nearest.distance < radius + range) touches.push_back({p, nearest, true});
  }
  if constexpr (D == 3) {
    const double rounding = 1e-9 * radius;
    for (SurfaceTouch<D> &touch : touches) {
      const Surface<D> &own = surface_of(touch);
      if (own.shape != WallShape::kMesh) continue;
      const Vec<D, double> point = x + touch.nearest.distance * touch.nearest.normal;
      for (const SurfaceTouch<D> &other : touches) {
        const Surface<D> &its = surface_of(other);
        if (its.wall != own.wall || other.place == touch.place) continue;
        const double farther = touch.nearest.distance - other.nearest.distance;
        if (farther < 0 || (farther == 0 && touch.place < other.place)) continue;
        const Vec<D, double> met = nearest_on_triangle(its.first, its.second, its.third, point);
        touch.counts = touch.counts && (met - point).norm() > rounding;
      }
    }
  }
}

}  // namespace dem
