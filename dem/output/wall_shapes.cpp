// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "dem/output/wall_shapes.hpp"

#include "dem/base/vector.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace output {
namespace {

using particles::Bounds;
using particles::Point;
using particles::WallKind;
using Vector = Eigen::Vector3d;

constexpr int kSides = 72;          // of what stands for a circle
constexpr double kBent = 0.94;      // the cosine of 20 degrees: edges of meshes that bend less are not shown
constexpr double kRounding = 1e-9;  // of edges

Vector vector_of(const double *numbers) { return {numbers[0], numbers[1], numbers[2]}; }
Point point_of(const Vector &v) { return {v.x(), v.y(), v.z()}; }

// In two dimensions all lies in the plane z = 0.
class Shapes {
 public:
  Shapes(const dem::Setup &setup, const std::vector<dem::WallReport> &walls, const particles::ParticleSet &state)
      : setup_(setup), state_(state) {
    for (size_t k = 0; k < walls.size(); k++) poses_.push_back(dem::pose_of<3>(setup.walls[k], walls[k].place));
  }

  particles::WallShapes all() {
    find_region();
    if (state_.has_box) add_box();
    for (wall_ = 0; static_cast<size_t>(wall_) < poses_.size(); wall_++) {
      const dem::WallBody &wall = setup_.walls[static_cast<size_t>(wall_)];
      const dem::WallPose<3> &pose = poses_[static_cast<size_t>(wall_)];
      if (wall.shape == dem::WallShape::kPlane) add_plane(pose.place(vector_of(wall.point)), vector_of(wall.normal));
      if (wall.shape == dem::WallShape::kCylinder) add_cylinder(wall, pose.place(vector_of(wall.point)));
      if (wall.shape == dem::WallShape::kMesh) add_mesh(wall, pose);
    }
    return std::move(shapes_);
  }

 private:
  bool is_flat() const { return setup_.dimension == 2; }

  void find_region() {
    if (state_.has_box) {
      region_.hold(point_of(vector_of(setup_.box_min)));
      region_.hold(point_of(vector_of(setup_.box_max)));
      return;
    }
    for (size_t i = 0; i < state_.count(); i++) {
      const double *x = state_.center(i);
      region_.hold({x[0], x[1], is_flat() ? 0 : x[2]}, state_.radii[i]);
    }
    for (size_t k = 0; k < poses_.size(); k++) {
      const std::vector<double> &corners = setup_.walls[k].corners;
      for (size_t c = 0; c + 2 < corners.size(); c += 3)
        region_.hold(point_of(poses_[k].place(vector_of(&corners[c]))));
    }
    if (region_.is_empty()) region_.hold({0, 0, 0});
    Bounds with_cylinders = region_;
    for (size_t k = 0; k < poses_.size(); k++) {
      const dem::WallBody &wall = setup_.walls[k];
      if (wall.shape != dem::WallShape::kCylinder) continue;
      for (const auto &ring : rings_of(wall, poses_[k].place(vector_of(wall.point)))) {
        for (const Point &point : ring) with_cylinders.hold(point);
      }
    }
    region_ = with_cylinders;
    if (is_flat()) region_.low[2] = region_.high[2] = 0;
  }

  void add_line(WallKind kind, std::vector<Point> points) { shapes_.lines.push_back({kind, wall_, std::move(points)}); }
  void add_face(WallKind kind, std::vector<Point> points) { shapes_.faces.push_back({kind, wall_, std::move(points)}); }

  // A corner of the box, by bits; layers of a tilted one are shifted along x and y.
  Point box_corner(unsigned bits) const {
    Point corner = region_.corner(bits);
    if (state_.is_tilted()) {
      const double up = (bits & 4) != 0 ? 1 : 0, deep = (bits & 2) != 0 ? 1 : 0;
      corner[0] += state_.tilt[0] * deep + state_.tilt[1] * up;
      corner[1] += state_.tilt[2] * up;
    }
    return corner;
  }

  void add_box() {
    wall_ = -1;
    const auto dimension = static_cast<unsigned>(setup_.dimension);
    const auto ends = [&](unsigned axis) { return setup_.walled[axis] || setup_.periodic[axis]; };
    for (unsigned from = 0; from < 1u << dimension; from++) {
      for (unsigned along = 0; along < dimension; along++) {
        const unsigned to = from | 1u << along;
        bool shown = false;
        for (unsigned axis = 0; axis < dimension; axis++) shown = shown || (axis != along && ends(axis));
        if (to != from && shown) add_line(WallKind::kBox, {box_corner(from), box_corner(to)});
      }
    }
    for (unsigned axis = 0; axis < 3 && !is_flat(); axis++) {
      if (!setup_.walled[axis]) continue;
      const unsigned one = 1u << (axis + 1) % 3, other = 1u << (axis + 2) % 3;
      for (const unsigned side : {0u, 1u << axis}) {
        add_face(WallKind::kBox,
                 {box_corner(side), box_corner(side | one), box_corner(side | one | other), box_corner(side | other)});
      }
    }
  }

  void add_plane(const Vector &point, const Vector &normal) {
    const Vector middle = vector_of(region_.middle().data());
    const Vector foot = middle - normal * normal.dot(middle - point);
    const double far = region_.diagonal();
    Bounds around = region_;
    around.grow(kRounding * far);
    if (is_flat()) {
      const Vector along = far * Vector(-normal.y(), normal.x(), 0);
      const std::vector<Point> segment = particles::clipped({point_of(foot - along), point_of(foot + along)}, around);
      if (segment.size() == 2) add_line(WallKind::kPlane, segment);
      return;
    }
    const Vector u = far * normal.unitOrthogonal(), v = normal.cross(u);
    std::vector<Point> face = particles::clipped(
        {point_of(foot - u - v), point_of(foot + u - v), point_of(foot + u + v), point_of(foot - u + v)}, around);
    if (face.size() < 3) return;
    add_face(WallKind::kPlane, face);
    face.push_back(face.front());
    add_line(WallKind::kPlane, std::move(face));
  }

  // The circles at both ends, closed; in two dimensions one.
  std::vector<std::vector<Point>> rings_of(const dem::WallBody &wall, const Vector &point) const {
    const Vector axis = is_flat() ? Vector::UnitZ() : vector_of(wall.normal);
    const Vector u = axis.unitOrthogonal(), v = axis.cross(u);
    double first = HUGE_VAL, last = -HUGE_VAL;
    for (unsigned bits = 0; bits < 8; bits++) {
      const double along = axis.dot(vector_of(region_.corner(bits).data()) - point);
      first = std::min(first, along);
      last = std::max(last, along);
    }
    std::vector<std::vector<Point>> rings;
    for (const double along : {first, last}) {
      std::vector<Point> &ring = rings.emplace_back();
      for (int k = 0; k <= kSides; k++) {
        const double angle = 2 * dem::kPi * (k % kSides) / kSides;
        const Vector out = std::cos(angle) * u + std::sin(angle) * v;
        ring.push_back(point_of(point + wall.radius * out + (is_flat() ? Vector::Zero() : Vector(along * axis))));
      }
      if (is_flat()) break;
    }
    return rings;
  }

  void add_cylinder(const dem::WallBody &wall, const Vector &point) {
    const std::vector<std::vector<Point>> rings = rings_of(wall, point);
    for (const std::vector<Point> &ring : rings) add_line(WallKind::kCylinder, ring);
    for (size_t k = 0; k < kSides && rings.size() == 2; k++)
      add_face(WallKind::kCylinder, {rings[0][k], rings[0][k + 1], rings[1][k + 1], rings[1][k]});
  }

  // Corners are the same where their numbers are. An edge that two faces go along in opposite directions has one
  // normal turned round, so that those of a flat surface cancel, whichever way its faces go round.
  void add_mesh(const dem::WallBody &wall, const dem::WallPose<3> &pose) {
    std::map<std::pair<Point, Point>, std::vector<Vector>> edges;
    for (size_t t = 0; t + 8 < wall.corners.size(); t += 9) {
      std::array<Vector, 3> corners;
      for (size_t k = 0; k < 3; k++) corners[k] = vector_of(&wall.corners[t + 3 * k]);
      const Vector normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
      std::vector<Point> face;
      for (size_t k = 0; k < 3; k++) {
        face.push_back(point_of(pose.place(corners[k])));
        const Point a = point_of(corners[k]), b = point_of(corners[(k + 1) % 3]);
        edges[std::minmax(a, b)].push_back(a < b ? normal : Vector(-normal));
      }
      add_face(WallKind::kMesh, std::move(face));
    }
    for (const auto &[ends, normals] : edges) {
      if (normals.size() == 2 && -normals[0].dot(normals[1]) > kBent) continue;
      add_line(WallKind::kMesh, {point_of(pose.place(vector_of(ends.first.data()))),
                                 point_of(pose.place(vector_of(ends.second.data())))});
    }
  }

  const dem::Setup &setup_;
  const particles::ParticleSet &state_;
  std::vector<dem::WallPose<3>> poses_;
  Bounds region_;
  particles::WallShapes shapes_;
  int64_t wall_ = -1;
};

}  // namespace

particles::WallShapes wall_shapes(const dem::Setup &setup, const std::vector<dem::WallReport> &walls,
                                  const particles::ParticleSet &state) {
  return Shapes(setup, walls, state).all();
}

}  // namespace output
