// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/draw/povray_walls.hpp"

#include "particles/text/formatted.hpp"
#include "programs/draw/povray_space.hpp"

#include <cmath>
#include <vector>

namespace draw {
namespace {

using particles::Bounds;
using particles::Point;
using particles::WallPart;

constexpr double kNear = 0.25, kAround = 0.01;  // of the longest edge of what there is to see
constexpr double kShortest = 1e-4;              // of the lines, in units of the scene

std::vector<Vector> in_view(const WallPart &part, std::vector<Point> points, const Bounds &view) {
  std::vector<Vector> result;
  if (has_no_end(part.kind)) points = particles::clipped(std::move(points), view);
  result.reserve(points.size());
  for (const Point &point : points) result.push_back(placed(point, view));
  return result;
}

std::vector<Point> upright(const WallPart &part, int dimension) {
  std::vector<Point> points;
  for (const Point &point : part.points) points.push_back(draw::upright(point, dimension));
  return points;
}

std::string lines_of(const WallPart &part, const Bounds &view, int dimension) {
  std::string text;
  const std::vector<Point> points = upright(part, dimension);
  for (size_t k = 0; k + 1 < points.size(); k++) {
    const std::vector<Vector> ends = in_view(part, {points[k], points[k + 1]}, view);
    if (ends.size() < 2) continue;
    const Vector &a = ends[0], &b = ends[1];
    if (std::hypot(b.x - a.x, b.y - a.y, b.z - a.z) > kShortest)
      text += "cylinder{" + text_of(a) + "," + text_of(b) + ",0.002}\n";
  }
  return text;
}

std::string triangles_of(const WallPart &part, const Bounds &view, int dimension) {
  std::string text;
  const std::vector<Vector> points = in_view(part, upright(part, dimension), view);
  for (size_t k = 1; k + 1 < points.size(); k++)
    text += "triangle{" + text_of(points[0]) + "," + text_of(points[k]) + "," + text_of(points[k + 1]) + "}\n";
  return text;
}

}  // namespace

void hold_walls(Bounds &view, const particles::WallShapes &walls, int dimension) {
  std::vector<Point> endless;
  for (const std::vector<WallPart> *parts : {&walls.lines, &walls.faces}) {
    for (const WallPart &part : *parts) {
      for (const Point &point : upright(part, dimension)) {
        if (has_no_end(part.kind)) {
          endless.push_back(point);
        } else {
          view.hold(point);
        }
      }
    }
  }
  const Bounds inner = view;
  const double near = kNear * inner.edge();
  for (const Point &point : endless) {
    for (size_t axis = 0; axis < 3; axis++) {
      if (point[axis] > inner.low[axis] - near) view.low[axis] = std::min(view.low[axis], point[axis]);
      if (point[axis] < inner.high[axis] + near) view.high[axis] = std::max(view.high[axis], point[axis]);
    }
  }
  view.grow(kAround * view.edge());
}

std::string povray_walls(const particles::WallShapes &walls, const Bounds &view, int dimension) {
  std::string lines, triangles;
  for (const WallPart &part : walls.lines) lines += lines_of(part, view, dimension);
  for (const WallPart &part : walls.faces) triangles += triangles_of(part, view, dimension);
  std::string text;
  const std::string plain = " finish{ambient 1 diffuse 0 specular 0}} no_shadow}\n";
  if (!lines.empty()) text += "union{\n" + lines + "texture{pigment{color rgbt <0.12,0.16,0.22,0.35>}" + plain;
  if (!triangles.empty()) text += "mesh{\n" + triangles + "texture{pigment{color rgbt <0.25,0.4,0.6,0.92>}" + plain;
  return text;
}

}  // namespace draw
