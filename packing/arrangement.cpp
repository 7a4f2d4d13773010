// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Random places by rejection and by inverting cumulative distributions.
#include "packing/arrangement.hpp"

#include "packing/portable_math.hpp"
#include "particles/error.hpp"

#include <algorithm>
#include <cmath>

namespace packing {
namespace {

constexpr int kClusters = 20;
constexpr double kClusterRadius = 0.02;  // b; lengths in edges of the box
constexpr double kFilmThickness = 0.05;
constexpr double kShellRadius = 0.4;  // to the middle of the shell
constexpr double kShellThickness = 0.02;
constexpr double kShellInside = kShellRadius - 0.5 * kShellThickness;
constexpr double kShellOutside = kShellRadius + 0.5 * kShellThickness;
constexpr double kCrowdedVolume = 0.01;
constexpr double kCrowdedShare = 0.99;  // of the particles

// The volume in which all would fit at the density of the middles. Plummer: n(0) = N / (4/3 pi b^3). In two dimensions
// it is seen along an axis: n(0) = N / (pi b^2).
double share_of_clusters(int dimension) { return kClusters * unit_ball(dimension) * power(kClusterRadius, dimension); }

double share_of_shell(int dimension) {
  return unit_ball(dimension) * (power(kShellOutside, dimension) - power(kShellInside, dimension));
}

}  // namespace

const std::vector<ArrangementRow> &arrangements() {
  static const std::vector<ArrangementRow> rows = {
      {Arrangement::kEven, "even", "the whole box", [](int) { return 1.0; }, &Thrower::everywhere},
      {Arrangement::kClusters, "clusters",
       "20 Plummer spheres, n(r) ~ (1 + (r/b)^2)^(-5/2), b = 0.02 edges; the density is that of their middles",
       share_of_clusters, &Thrower::into_clusters},
      {Arrangement::kFilm, "film", "a layer of 0.05 edges normal to the last axis", [](int) { return kFilmThickness; },
       &Thrower::into_film},
      {Arrangement::kShell, "shell", "a hollow sphere (ring) of radius 0.4 and thickness 0.02 edges", share_of_shell,
       &Thrower::into_shell},
      {Arrangement::kCrowded, "crowded", "99 % in a corner of 1 % of the box", [](int) { return kCrowdedVolume; },
       &Thrower::into_crowd}};
  return rows;
}

const ArrangementRow &row_of(Arrangement arrangement) {
  return *std::find_if(arrangements().begin(), arrangements().end(),
                       [&](const ArrangementRow &row) { return row.arrangement == arrangement; });
}

Arrangement arrangement_from_name(const std::string &name) {
  for (const ArrangementRow &row : arrangements())
    if (row.name == name) return row.arrangement;
  throw particles::Error("no arrangement is called '" + name + "'");
}

Thrower::Thrower(Arrangement arrangement, const Box &box, Random &random)
    : draw_(row_of(arrangement).draw), box_(box), random_(random) {}

void Thrower::operator()(double radius, double *center) {
  (this->*draw_)(radius, center);
  for (int axis = 0; axis < box_.dimension(); axis++) center[axis] = box_.keep(axis, center[axis], radius);
}

void Thrower::everywhere(double radius, double *center) {
  for (int axis = 0; axis < box_.dimension(); axis++) {
    const double low = box_.is_periodic(axis) ? 0 : radius;
    const double high = box_.is_periodic(axis) ? box_.edge(axis) : box_.edge(axis) - radius;
    center[axis] = low + random_.uniform() * (high - low);
  }
}

// A unit vector, all directions alike.
Vector Thrower::draw_direction() {
  Vector direction;
  do {
    for (double &component : direction) component = 2 * random_.uniform() - 1;
  } while (square(direction) > 1 || square(direction) < 1e-6);
  return direction / std::sqrt(square(direction));
}

// False if the place is outside the box: the density has no end.
bool Thrower::in_cluster(const std::array<double, 3> &middle, double *center) {
  const Vector direction = draw_direction();
  // The share within r is (1 + (b/r)^2)^(-3/2): Aarseth, Henon & Wielen, Astron. Astrophys. 37 (1974) 183.
  const double within = root(1 - random_.uniform(), 3);
  const double inverse_square = 1 / (within * within) - 1;  // (b/r)^2
  if (!(inverse_square > 0)) return false;
  const double distance = kClusterRadius * box_.edge(0) / std::sqrt(inverse_square);
  bool inside = true;
  for (int axis = 0; axis < box_.dimension(); axis++) {
    center[axis] = middle[static_cast<size_t>(axis)] + distance * direction[axis];
    inside = inside && center[axis] >= 0 && center[axis] < box_.edge(axis);
  }
  return inside;
}

void Thrower::into_clusters(double, double *center) {
  while (clusters_.size() < kClusters) {
    std::array<double, 3> &middle = clusters_.emplace_back();
    for (double &x : middle) x = box_.edge(0) * (0.1 + 0.8 * random_.uniform());
  }
  while (!in_cluster(clusters_[random_.below(clusters_.size())], center)) continue;
}

void Thrower::into_film(double radius, double *center) {
  everywhere(radius, center);
  const int last = box_.dimension() - 1;
  center[last] = box_.edge(last) * (0.5 + kFilmThickness * (random_.uniform() - 0.5));
}

void Thrower::into_shell(double, double *center) {
  constexpr double kHollow = 1 - kShellThickness / kShellOutside;  // the inner radius over the outer one
  double square = 0;
  do {
    square = 0;
    for (int axis = 0; axis < box_.dimension(); axis++) {
      center[axis] = 2 * random_.uniform() - 1;
      square += center[axis] * center[axis];
    }
  } while (square > 1 || square < kHollow * kHollow);
  for (int axis = 0; axis < box_.dimension(); axis++)
    center[axis] = box_.edge(axis) * (0.5 + kShellOutside * center[axis]);
}

void Thrower::into_crowd(double radius, double *center) {
  const bool crowd = random_.uniform() < kCrowdedShare;
  everywhere(radius, center);
  if (!crowd) return;
  for (int axis = 0; axis < box_.dimension(); axis++) center[axis] *= root(kCrowdedVolume, box_.dimension());
}

}  // namespace packing
