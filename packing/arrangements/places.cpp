// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Shapes by shaken lattices, random places by rejection; no function of the C library but the square root.
#include "packing/arrangements/places.hpp"

#include "packing/portable_math.hpp"

#include <algorithm>
#include <cmath>

namespace packing {
namespace {

// How far a place of a lattice is moved along each axis at most, in spacings. At the usual density some neighbours of
// spheres then overlap and some do not.
constexpr double kShake = 0.08;

// Calls `visit` with each point of whole coordinates from -reach to reach on the first `axes` axes, x fastest.
template <class Visit>
void for_points(int axes, int64_t reach, Visit visit) {
  const int64_t y_reach = axes > 1 ? reach : 0, z_reach = axes > 2 ? reach : 0;
  for (int64_t z = -z_reach; z <= z_reach; z++)
    for (int64_t y = -y_reach; y <= y_reach; y++)
      for (int64_t x = -reach; x <= reach; x++)
        visit(Vector(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)));
}

}  // namespace

Places::Places(int dimension, size_t count, double density, Random &random)
    : dimension_(dimension),
      count_(count),
      volume_of_one_(unit_ball(dimension) / density),
      spacing_(root(volume_of_one_, dimension)),
      random_(&random) {
  centers_.reserve(count);
}

double Places::edge(double particles) const { return root(volume(particles), dimension_); }

Vector Places::draw_in_cube(double edge_of_cube) const {
  Vector place = Vector::Zero();
  for (int axis = 0; axis < dimension_; axis++) place[axis] = edge_of_cube * random_->uniform();
  return place;
}

Vector Places::draw_in_ball(int axes) const {
  Vector place = Vector::Zero();
  do {
    for (int axis = 0; axis < axes; axis++) place[axis] = 2 * random_->uniform() - 1;
  } while (square(place) > 1);
  return place;
}

Vector Places::draw_off_middle(int axes) const {
  Vector place;
  do {
    place = draw_in_ball(axes);
  } while (square(place) < 1e-6);
  return place;
}

Vector Places::draw_direction() const {
  const Vector place = draw_off_middle(dimension_);
  return place / std::sqrt(square(place));
}

void Places::add(const Vector &center) {
  if (left() > 0) centers_.push_back(center);
}

Vector Places::shaken(const Vector &place) const {
  Vector moved = place;
  for (int axis = 0; axis < dimension_; axis++) moved[axis] += kShake * spacing() * (2 * random_->uniform() - 1);
  return moved;
}

size_t Places::points_along(size_t particles) const {
  size_t points = 1;
  while (power(static_cast<double>(points), dimension_) < static_cast<double>(particles)) points++;
  return points;
}

double Places::lattice_edge(size_t particles) const { return static_cast<double>(points_along(particles)) * spacing(); }

void Places::add_cube(size_t particles, const Vector &low) {
  const size_t points = points_along(particles);
  Vector half = Vector::Zero();  // from the corner to the first point
  for (int axis = 0; axis < dimension_; axis++) half[axis] = 0.5;
  for (size_t k = 0; k < particles; k++) {
    const size_t x = k % points, y = k / points % points, z = k / points / points;
    const Vector point(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
    add(shaken(low + spacing() * (point + half)));
  }
}

void Places::add_ball(size_t particles, const Vector &middle) {
  const size_t most = centers_.size() + std::max(particles, size_t{1});
  const double radius = root(static_cast<double>(particles) / unit_ball(dimension_), dimension_);  // in spacings
  for_points(dimension_, static_cast<int64_t>(radius), [&](const Vector &point) {
    if (square(point) <= radius * radius && centers_.size() < most) add(shaken(middle + spacing() * point));
  });
}

double Places::add_cone(size_t particles, const Vector &tip, int way, double slope) {
  const size_t most = centers_.size() + std::min(particles, left());
  double height = 0;  // in spacings
  for (int64_t n = 0; centers_.size() < most; n++) {
    const auto layer = static_cast<double>(n);
    height = layer;
    const double radius = layer / slope;
    for_points(last_axis(), static_cast<int64_t>(radius), [&](Vector point) {
      if (square(point) > radius * radius || centers_.size() >= most) return;
      point[last_axis()] = way * layer;
      add(shaken(tip + spacing() * point));
    });
  }
  return height * spacing();
}

}  // namespace packing
