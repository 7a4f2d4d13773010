// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Walls beside those of the box, for their tests.
#pragma once

#include "tests/dem/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace bodies {

constexpr double kStiffness = 1e4;

inline dem::WallBody plane(const std::vector<double> &point, const std::vector<double> &normal) {
  dem::WallBody wall;
  wall.name = "plane";
  std::copy(point.begin(), point.end(), wall.point);
  std::copy(normal.begin(), normal.end(), wall.normal);
  std::copy(point.begin(), point.end(), wall.pivot);
  if (normal.size() == 3) std::copy(normal.begin(), normal.end(), wall.axis);
  return wall;
}

inline dem::WallBody cylinder(const std::vector<double> &point, double radius) {
  dem::WallBody wall;
  wall.name = "cylinder";
  wall.shape = dem::WallShape::kCylinder;
  wall.radius = radius;
  std::copy(point.begin(), point.end(), wall.point);
  std::copy(point.begin(), point.end(), wall.pivot);
  if (point.size() == 3) wall.normal[2] = 1;
  return wall;
}

using Corner = std::vector<double>;

inline dem::WallBody mesh(const std::vector<Corner> &corners) {
  dem::WallBody wall;
  wall.name = "mesh";
  wall.shape = dem::WallShape::kMesh;
  for (const Corner &corner : corners) wall.corners.insert(wall.corners.end(), corner.begin(), corner.end());
  return wall;
}

// The square [-a, a] x [-a, a] at z = 0 in triangles between n + 1 lines each way.
inline dem::WallBody tiled_floor(double a, int n) {
  std::vector<Corner> corners;
  const auto at = [&](int i, int j) { return Corner{a * (2.0 * i / n - 1), a * (2.0 * j / n - 1), 0}; };
  for (int i = 0; i < n; i++) {
    for (int j = 0; j < n; j++) {
      for (const Corner &corner :
           {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)}) {
        corners.push_back(corner);
      }
    }
  }
  return mesh(corners);
}

inline dem::Setup with_walls(int dimension, const std::vector<dem::WallBody> &walls, double restitution = 1) {
  dem::Setup setup;
  setup.dimension = dimension;
  setup.effects = dem::kSurfaces;
  setup.walls = walls;
  set_linear(setup, kStiffness, restitution);
  return setup;
}

inline bool near(double value, double expected, double tolerance, const char *what) {
  const bool good = std::fabs(value - expected) <= tolerance;
  std::printf("%s: %.10g (%.10g)%s\n", what, value, expected, good ? "" : "  <- too far");
  return good;
}

}  // namespace bodies
