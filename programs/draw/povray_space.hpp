// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The space of a scene for POV-Ray: the longest edge of what is drawn is 1, its middle the origin, z upwards; discs lie
// in the plane y = 0.
#pragma once

#include "particles/clipping.hpp"
#include "particles/text/formatted.hpp"

#include <string>

namespace draw {

struct Vector {
  double x = 0, y = 0, z = 0;
};

inline Vector operator*(double factor, const Vector &v) { return {factor * v.x, factor * v.y, factor * v.z}; }

inline std::string text_of(const Vector &v) { return particles::formatted("<%.5f,%.5f,%.5f>", v.x, v.y, v.z); }

// Where a point stands that has two coordinates, or three.
inline particles::Point upright(const particles::Point &point, int dimension) {
  return dimension == 2 ? particles::Point{point[0], 0, point[1]} : point;
}

// To the units of the scene.
inline Vector placed(const particles::Point &point, const particles::Bounds &view) {
  const particles::Point middle = view.middle();
  const double edge = view.edge();
  return {(point[0] - middle[0]) / edge, (point[1] - middle[1]) / edge, (point[2] - middle[2]) / edge};
}

}  // namespace draw
