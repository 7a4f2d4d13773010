// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Worlds that reach far beyond their particles: no grid of cells over them can have a size.
#include "packing/arrangements/families.hpp"
#include "packing/portable_math.hpp"

#include <algorithm>
#include <cmath>

namespace packing {
namespace {

constexpr double kApart = 2e6;  // of `far`
constexpr double kShortestStep = 1.2, kLongestStep = 1e6;
constexpr size_t kGroup = 5;
constexpr double kDecades = 12;
constexpr double kLn10 = 2.302585092994045684;

Vector in_dimension(Vector place, const Places &places) {
  if (places.dimension() == 2) place[2] = 0;
  return place;
}

}  // namespace

void lay_far(Places &places) {
  const Vector there = places.dimension() == 2 ? Vector(0.8, 0.6, 0) : Vector(6.0 / 7, 3.0 / 7, 2.0 / 7);
  places.add_cube(places.count() / 2, Vector::Zero());
  places.add_cube(places.left(), kApart * there);
}

// The first two of the three overlap.
void lay_outliers(Places &places) {
  const size_t far_away = std::min(size_t{3}, places.count() - 1);
  places.add_cube(places.count() - far_away, Vector::Zero());
  for (const Vector &place : {Vector(1e15, -1e12, 3e9), Vector(1e15 + 1, -1e12, 3e9), Vector(-1e18, 1e200, 1e100)})
    places.add(in_dimension(place, places));
}

void lay_dust(Places &places) {
  Vector place = Vector::Zero();
  while (places.left() > 0) {
    // The share w of steps that are longer lies in (0, 1]: s = s_min w^(-3/4).
    const double root_of_w = std::sqrt(1 - places.random().uniform());
    const double step = std::min(kShortestStep / (root_of_w * std::sqrt(root_of_w)), kLongestStep);
    place += step * places.draw_direction();
    places.add(place);
  }
}

void lay_scales(Places &places) {
  const double edge = places.edge(kGroup);
  while (places.left() > 0) {
    Vector low = Vector::Zero();
    for (int axis = 0; axis < places.dimension(); axis++) {
      const double sign = places.random().uniform() < 0.5 ? -1 : 1;
      low[axis] = sign * exponential(kDecades * kLn10 * places.random().uniform());
    }
    for (size_t k = 0; k < kGroup; k++) places.add(low + places.draw_in_cube(edge));
  }
}

}  // namespace packing
