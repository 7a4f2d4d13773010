// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where in the box particles are thrown: evenly, or as unevenly as nature may have it.
#pragma once

#include "packing/box.hpp"
#include "packing/random.hpp"

#include <array>
#include <string>
#include <vector>

namespace packing {

enum class Arrangement { kEven, kClusters, kFilm, kShell, kCrowded };

// Draws centres. Each arrangement has its own way, a member whose centres may still be too near to a wall.
class Thrower {
 public:
  // `box` and `random` must outlive the thrower.
  Thrower(Arrangement arrangement, const Box &box, Random &random);

  // A centre in the box, no nearer to a wall than `radius`.
  void operator()(double radius, double *center);

  void everywhere(double radius, double *center);
  void into_clusters(double radius, double *center);
  void into_film(double radius, double *center);
  void into_shell(double radius, double *center);
  void into_crowd(double radius, double *center);

 private:
  Vector draw_direction();
  bool in_cluster(const std::array<double, 3> &middle, double *center);

  void (Thrower::*draw_)(double radius, double *center);
  const Box &box_;
  Random &random_;
  std::vector<std::array<double, 3>> clusters_;  // their middles, drawn when the first particle is thrown
};

struct ArrangementRow {
  Arrangement arrangement;
  const char *name;    // the word of `hgrid pack --arrangement`
  const char *places;  // where particles are, in words
  // The share of the box that particles are thrown into: a density is understood to be that in this part.
  double (*share)(int dimension);
  void (Thrower::*draw)(double radius, double *center);
};

// All arrangements: what is offered, described and thrown comes from here.
const std::vector<ArrangementRow> &arrangements();

const ArrangementRow &row_of(Arrangement arrangement);

// Throws particles::Error naming it if there is no such arrangement.
Arrangement arrangement_from_name(const std::string &name);

}  // namespace packing
