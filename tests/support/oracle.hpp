// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The answers that the library must give, found pair by pair without it.
//
// The rule (interaction, margin, periodic axes, dimension) is read from the definition of the grid; nothing else of
// the library is used. The exact oracle decides in rational numbers; doubles only spare it the clear cases.
#pragma once

#include <hgrid/hgrid.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hgtest {

struct Particles {
  int dimension = 3;
  std::vector<double> centers;  // [count][dimension]
  std::vector<double> radii;

  size_t size() const { return radii.size(); }
  const double *center(size_t i) const { return &centers[i * static_cast<size_t>(dimension)]; }
  void add(const double *center, double radius) {
    for (int k = 0; k < dimension; k++) centers.push_back(center[k]);
    radii.push_back(radius);
  }
};

struct Sphere {
  const double *center;
  double radius;
};

// Whether a and b interact in real arithmetic on the stored doubles.
bool exact_interact(const hg_grid_def &def, const Sphere &a, const Sphere &b);
// The same with the plain expression in doubles that HG_DOUBLE promises.
bool double_interact(const hg_grid_def &def, const Sphere &a, const Sphere &b);
// How far a and b are from touching: distance / reach - 1, from exact squares. Needs reach > 0.
double relative_gap(const hg_grid_def &def, const Sphere &a, const Sphere &b);

using Interact = bool(const hg_grid_def &, const Sphere &, const Sphere &);
using Pairs = std::vector<hg_pair>;

inline bool pair_less(const hg_pair &p, const hg_pair &q) { return p.a != q.a ? p.a < q.a : p.b < q.b; }
inline bool pair_equal(const hg_pair &p, const hg_pair &q) { return p.a == q.a && p.b == q.b; }

// Pairs of rows of `particles` as ids (row + index_base), ascending.
Pairs all_pairs(const hg_grid_def &def, const Particles &particles, Interact *interact);
// The same with ids given, ascending.
Pairs all_pairs(const hg_grid_def &def, const Particles &particles, const std::vector<int32_t> &ids,
                Interact *interact);
// Rows that interact with the sphere as ids (row + index_base), ascending.
std::vector<int32_t> all_in_sphere(const hg_grid_def &def, const Particles &particles, const Sphere &sphere,
                                   Interact *interact);

}  // namespace hgtest
