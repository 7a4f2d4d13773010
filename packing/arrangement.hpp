// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where in the box particles are thrown: evenly, or as unevenly as nature may have it.
#pragma once

#include "packing/container.hpp"
#include "packing/random.hpp"

#include <array>
#include <string>
#include <vector>

namespace packing {

enum class Arrangement {
  kEven,      // the whole box
  kClusters,  // 20 clusters of Plummer's density (1 + (r/b)^2)^(-5/2), b = 0.02 edges
  kFilm,      // a layer of 0.05 edges normal to the last axis
  kShell,     // a hollow sphere (ring) about the centre of the box, radius 0.4 edges, thickness 0.02 edges
  kCrowded    // 99 % in a corner of 1 % of the box
};

// The names that arrangement_from_name knows, in the order of the enum.
extern const char *const kArrangementNames[5];

// Throws std::invalid_argument naming it if there is no such arrangement.
Arrangement arrangement_from_name(const std::string &name);

// The share of the box that particles are thrown into: a density is understood to be that in this part. For clusters,
// the volume in which they would fit at the density of their middles.
double volume_share(Arrangement arrangement, int dimension);

// Draws centres. Clusters get their places from `random` first.
class Thrower {
 public:
  Thrower(Arrangement arrangement, const Container &container, packing::Random &random);

  // A centre in the box, no nearer to a wall than `radius`.
  void operator()(double radius, double *center);

 private:
  double even(int axis, double radius);
  void draw_direction(double *direction);
  bool in_cluster(double *center);
  void in_shell(double *center);

  Arrangement arrangement_;
  const Container &container_;
  packing::Random &random_;
  std::vector<std::array<double, 3>> clusters_;
};

}  // namespace packing
