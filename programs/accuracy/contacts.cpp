// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/contacts.hpp"

#include "particles/insert.hpp"

#include <algorithm>
#include <cmath>

namespace accuracy {

std::vector<hg_pair> found_pairs(const hg_grid_def &def, const particles::ParticleSet &particles) {
  hgrid::Grid grid(def);
  particles::insert(particles, grid);
  const hgrid::View<hg_pair> pairs = grid.query_pairs();
  return {pairs.begin(), pairs.end()};
}

void filter_pairs(const particles::ParticleSet &particles, const std::vector<hg_pair> &candidates,
                  std::vector<hg_pair> &pairs) {
  const double *centers = particles.centers.data(), *radii = particles.radii.data();
  for (const hg_pair &pair : candidates) {
    const double *x = centers + 3 * size_t(pair.a), *y = centers + 3 * size_t(pair.b);
    const double dx = x[0] - y[0], dy = x[1] - y[1], dz = x[2] - y[2], reach = radii[pair.a] + radii[pair.b];
    if (dx * dx + dy * dy + dz * dz < reach * reach) pairs.push_back(pair);
  }
}

double overlap_of(const particles::ParticleSet &particles, const hg_pair &pair) {
  const auto a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
  double square = 0;
  for (int axis = 0; axis < particles.dimension; axis++) {
    double between = particles.center(b)[axis] - particles.center(a)[axis];
    const double period = particles.box_max[axis] - particles.box_min[axis];
    if (particles.periodic[axis] != 0) between -= period * std::round(between / period);
    square += between * between;
  }
  return particles.radii[a] + particles.radii[b] - std::sqrt(square);
}

double relative_overlap(const particles::ParticleSet &particles, const hg_pair &pair) {
  const double r_a = particles.radii[static_cast<size_t>(pair.a)], r_b = particles.radii[static_cast<size_t>(pair.b)];
  return overlap_of(particles, pair) / std::min(r_a, r_b);
}

}  // namespace accuracy
