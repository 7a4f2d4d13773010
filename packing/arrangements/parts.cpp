// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A cube in a periodic box of eight times its edge, as a process of a parallel program holds it.
#include "packing/arrangements/families.hpp"

namespace packing {
namespace {

constexpr double kBoxEdge = 8;  // in edges of the cube

// `low`: the lowest corner on each axis, in edges of the cube. What lies below 0 is wrapped later.
void lay_cube_at(double low, Places &places) {
  const double edge = places.lattice_edge(places.count());
  Vector corner = Vector::Zero();
  for (int axis = 0; axis < places.dimension(); axis++) corner[axis] = low * edge;
  places.add_cube(places.count(), corner);
  places.set_box(kBoxEdge * edge);
}

}  // namespace

void lay_part(Places &places) { lay_cube_at(3, places); }

void lay_part_across(Places &places) { lay_cube_at(-0.5, places); }

}  // namespace packing
