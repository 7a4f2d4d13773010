// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Tubes whose axes walk at random.
#include "packing/arrangements/families.hpp"
#include "packing/portable_math.hpp"

#include <cmath>

namespace packing {
namespace {

constexpr size_t kTubes = 30;
constexpr double kTubeRadius = 4;
constexpr double kRoomEdge = 30;  // in edges of a cube of all particles
// Of the direction, from one particle to the next: the axis forgets it after some 40 diameters.
constexpr double kBend = 0.04;

Vector bent(Vector direction, const Places &places) {
  for (int axis = 0; axis < places.dimension(); axis++) direction[axis] += kBend * places.random().normal();
  return direction / std::sqrt(square(direction));
}

}  // namespace

void lay_filaments(Places &places) {
  const double section = places.dimension() == 2 ? 2 * kTubeRadius : unit_ball(2) * kTubeRadius * kTubeRadius;
  const double step = places.volume(1) / section;
  const size_t of_a_tube = (places.count() + kTubes - 1) / kTubes;
  while (places.left() > 0) {
    Vector axis = places.draw_in_cube(kRoomEdge * places.edge_of_all());
    Vector direction = places.draw_direction();
    for (size_t k = 0; k < of_a_tube; k++) {
      direction = bent(direction, places);
      axis += step * direction;
      places.add(axis + kTubeRadius * places.draw_in_ball(places.dimension()));
    }
  }
}

}  // namespace packing
