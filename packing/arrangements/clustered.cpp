// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Dense parts in a thin cloud, Plummer spheres, a gas.
#include "packing/arrangements/families.hpp"
#include "packing/portable_math.hpp"

#include <cmath>

namespace packing {
namespace {

constexpr size_t kClusters = 20;
constexpr double kClusterRadius = 0.02;  // b, in edges of the cube
constexpr size_t kClumps = 50;
constexpr double kClumpedShare = 0.8;
constexpr double kCloudEdge = 30;  // in edges of a cube of all particles
constexpr double kCrowdedShare = 0.99;
constexpr double kRoomOfCrowd = 100;  // the volume around, in its own

// A place of one Plummer sphere of radius b = 1. In two dimensions it is seen along an axis.
Vector draw_in_cluster(const Places &places) {
  double inverse_square = 0;  // (b/r)^2; at 0 the place would be infinitely far
  while (!(inverse_square > 0)) {
    // The share within r is (1 + (b/r)^2)^(-3/2): Aarseth, Henon & Wielen, Astron. Astrophys. 37 (1974) 183.
    const double within = root(1 - places.random().uniform(), 3);
    inverse_square = 1 / (within * within) - 1;
  }
  Vector direction = places.draw_off_middle(3);
  direction /= std::sqrt(square(direction) * inverse_square);
  if (places.dimension() == 2) direction[2] = 0;
  return direction;
}

}  // namespace

void lay_gas(Places &places) {
  const double edge = places.edge_of_all();
  while (places.left() > 0) places.add(places.draw_in_cube(edge));
}

// The density of the middle of a Plummer sphere of N particles is N / b^3 (seen along an axis: N / b^2).
void lay_clusters(Places &places) {
  const double of_a_cluster = static_cast<double>(places.count()) / kClusters;
  const double radius = places.edge(of_a_cluster / unit_ball(places.dimension()));
  const double edge = radius / kClusterRadius;
  Vector middles[kClusters];
  for (Vector &middle : middles) {
    middle = places.draw_in_cube(0.8 * edge);
    for (int axis = 0; axis < places.dimension(); axis++) middle[axis] += 0.1 * edge;
  }
  while (places.left() > 0) {
    const Vector &middle = middles[places.random().below(kClusters)];
    const Vector place = middle + radius * draw_in_cluster(places);
    if (place.minCoeff() >= 0 && place.maxCoeff() < edge) places.add(place);
  }
}

void lay_clumps(Places &places) {
  const double edge = kCloudEdge * places.edge_of_all();
  const size_t of_a_clump = places.share(kClumpedShare / kClumps);
  for (size_t thin = places.share(1 - kClumpedShare); thin > 0; thin--) places.add(places.draw_in_cube(edge));
  // A ball of a lattice holds about what it should: some more or less than 50 of them.
  while (places.left() > 0) places.add_ball(of_a_clump, places.draw_in_cube(edge));
}

void lay_crowd(Places &places) {
  const double inner = places.lattice_edge(places.share(kCrowdedShare));
  const double outer = inner * root(kRoomOfCrowd, places.dimension());
  Vector low = Vector::Zero();
  for (int axis = 0; axis < places.dimension(); axis++) low[axis] = 0.5 * (outer - inner);
  places.add_cube(places.share(kCrowdedShare), low);
  while (places.left() > 0) places.add(places.draw_in_cube(outer));
}

}  // namespace packing
