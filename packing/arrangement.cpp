// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Random places by rejection and by inverting cumulative distributions.
#include "packing/arrangement.hpp"

#include "packing/portable_math.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace packing {
namespace {

constexpr double kPi = 3.14159265358979323846;

constexpr int kClusters = 20;
constexpr double kClusterRadius = 0.02;  // b; lengths in edges of the box
constexpr double kFilmThickness = 0.05;
constexpr double kShellRadius = 0.4;  // to the middle of the shell
constexpr double kShellThickness = 0.02;
constexpr double kCrowdedVolume = 0.01;
constexpr double kCrowdedShare = 0.99;  // of the particles

}  // namespace

const char *const kArrangementNames[5] = {"even", "clusters", "film", "shell", "crowded"};

Arrangement arrangement_from_name(const std::string &name) {
  const auto *const found = std::find(std::begin(kArrangementNames), std::end(kArrangementNames), name);
  if (found != std::end(kArrangementNames)) return static_cast<Arrangement>(found - std::begin(kArrangementNames));
  throw std::invalid_argument("no arrangement is called '" + name + "'");
}

double volume_share(Arrangement arrangement, int dimension) {
  constexpr double kInner = kShellRadius - 0.5 * kShellThickness, kOuter = kShellRadius + 0.5 * kShellThickness;
  const double unit_ball = dimension == 2 ? kPi : 4 * kPi / 3;
  switch (arrangement) {
    case Arrangement::kClusters:
      // Plummer: n(0) = N / (4/3 pi b^3). In two dimensions it is seen along an axis: n(0) = N / (pi b^2).
      return kClusters * unit_ball * power(kClusterRadius, dimension);
    case Arrangement::kFilm:
      return kFilmThickness;
    case Arrangement::kShell:
      return unit_ball * (power(kOuter, dimension) - power(kInner, dimension));
    case Arrangement::kCrowded:
      return kCrowdedVolume;
    case Arrangement::kEven:
      break;
  }
  return 1;
}

Thrower::Thrower(Arrangement arrangement, const Container &container, packing::Random &random)
    : arrangement_(arrangement), container_(container), random_(random) {
  if (arrangement != Arrangement::kClusters) return;
  clusters_.resize(kClusters);
  for (std::array<double, 3> &center : clusters_) {
    for (double &x : center) x = container.edge * (0.1 + 0.8 * random.uniform());
  }
}

double Thrower::even(int axis, double radius) {
  const bool periodic = container_.periodic[static_cast<size_t>(axis)];
  const double low = periodic ? 0 : radius;
  const double high = periodic ? container_.edge : container_.edge - radius;
  return low + random_.uniform() * (high - low);
}

// A unit vector, all directions alike.
void Thrower::draw_direction(double *direction) {
  double square = 0;
  do {
    square = 0;
    for (int k = 0; k < 3; k++) {
      direction[k] = 2 * random_.uniform() - 1;
      square += direction[k] * direction[k];
    }
  } while (square > 1 || square < 1e-6);
  for (int k = 0; k < 3; k++) direction[k] /= std::sqrt(square);
}

// False if the place is outside the box: the density has no end.
bool Thrower::in_cluster(double *center) {
  const std::array<double, 3> &middle = clusters_[random_.below(clusters_.size())];
  double direction[3];
  draw_direction(direction);
  // The share within r is (1 + (b/r)^2)^(-3/2): Aarseth, Henon & Wielen, Astron. Astrophys. 37 (1974) 183.
  const double within = root(1 - random_.uniform(), 3);
  const double square = 1 / (within * within) - 1;
  if (!(square > 0)) return false;
  const double distance = kClusterRadius * container_.edge / std::sqrt(square);
  bool inside = true;
  for (int k = 0; k < container_.dimension; k++) {
    center[k] = middle[static_cast<size_t>(k)] + distance * direction[k];
    inside = inside && center[k] >= 0 && center[k] < container_.edge;
  }
  return inside;
}

void Thrower::in_shell(double *center) {
  constexpr double kOuter = kShellRadius + 0.5 * kShellThickness;
  constexpr double kShare = 1 - kShellThickness / kOuter;
  double square = 0;
  do {
    square = 0;
    for (int k = 0; k < container_.dimension; k++) {
      center[k] = 2 * random_.uniform() - 1;
      square += center[k] * center[k];
    }
  } while (square > 1 || square < kShare * kShare);
  for (int k = 0; k < container_.dimension; k++) center[k] = container_.edge * (0.5 + kOuter * center[k]);
}

void Thrower::operator()(double radius, double *center) {
  const int last = container_.dimension - 1;
  const bool crowd = arrangement_ == Arrangement::kCrowded && random_.uniform() < kCrowdedShare;
  if (arrangement_ == Arrangement::kClusters) {
    while (!in_cluster(center)) continue;
  } else if (arrangement_ == Arrangement::kShell) {
    in_shell(center);
  } else {
    for (int k = 0; k <= last; k++) center[k] = even(k, radius);
  }
  if (arrangement_ == Arrangement::kFilm) {
    center[last] = container_.edge * (0.5 + kFilmThickness * (random_.uniform() - 0.5));
  }
  if (crowd) {
    for (int k = 0; k <= last; k++) center[k] *= root(kCrowdedVolume, container_.dimension);
  }
  for (int k = 0; k <= last; k++) center[k] = container_.keep(k, center[k], radius);
}

}  // namespace packing
