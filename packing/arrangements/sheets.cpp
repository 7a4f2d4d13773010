// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A film along no axis and the shell of a sphere.
#include "packing/arrangements/families.hpp"
#include "packing/portable_math.hpp"

namespace packing {
namespace {

constexpr double kThickness = 4;

}  // namespace

void lay_film(Places &places) {
  const int dimension = places.dimension();
  // Orthogonal unit vectors, the last normal to the film.
  const Vector axes[3] = {Vector(1, 2, 2) / 3, Vector(2, 1, -2) / 3, Vector(2, -2, 1) / 3};
  const Vector flat_axes[2] = {{0.8, 0.6, 0}, {-0.6, 0.8, 0}};
  const Vector *directions = dimension == 2 ? flat_axes : axes;
  const double edge = root(places.volume(static_cast<double>(places.count())) / kThickness, dimension - 1);
  while (places.left() > 0) {
    Vector place = Vector::Zero();
    for (int axis = 0; axis < dimension; axis++)
      place += (axis + 1 < dimension ? edge : kThickness) * places.random().uniform() * directions[axis];
    places.add(place);
  }
}

void lay_shell(Places &places) {
  const int dimension = places.dimension();
  const double surface = dimension * unit_ball(dimension);  // of the unit sphere
  const double inside =
      root(places.volume(static_cast<double>(places.count())) / (kThickness * surface), dimension - 1);
  while (places.left() > 0) {
    const double distance = inside + kThickness * places.random().uniform();
    places.add(distance * places.draw_direction());
  }
}

}  // namespace packing
