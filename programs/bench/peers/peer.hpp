// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What the other programs have in common: they propose candidates, the plain double expression decides.
#pragma once

#include "programs/bench/cell_array.hpp"

#include <hgrid/types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace bench {

// Builds whatever the peer needs from the particles and fills the list with all overlapping pairs, a < b; the list
// comes empty and keeps its memory between calls.
using PairFinder = std::function<void(std::vector<hg_pair> &)>;

struct Peer {
  std::string name;
  std::string variant;  // of several with one name the fastest counts
  // Called once, before the clock runs: what a simulation would keep between its steps. Gives an empty function if the
  // variant makes no sense for these particles.
  std::function<PairFinder(const Particles &)> prepare;
};

// Centre and radius side by side: a test of two random particles reads two lines of memory instead of four.
struct Sphere {
  double x[3];
  double r;
};

inline void copy_spheres(const Particles &particles, std::vector<Sphere> &spheres) {
  spheres.resize(particles.count);
  for (size_t i = 0; i < particles.count; i++) {
    const double *c = particles.centers + 3 * i;
    spheres[i] = {{c[0], c[1], c[2]}, particles.radii[i]};
  }
}

// The predicate of the plain searches, see cell_array.hpp.
inline bool overlap(const Sphere &p, const Sphere &q) {
  const double dx = p.x[0] - q.x[0], dy = p.x[1] - q.x[1], dz = p.x[2] - q.x[2];
  const double s = p.r + q.r;
  return dx * dx + dy * dy + dz * dz < s * s;
}

// Keeps a candidate, in either order, if it overlaps.
inline void keep_if_overlapping(const std::vector<Sphere> &spheres, int32_t a, int32_t b, std::vector<hg_pair> &pairs) {
  if (overlap(spheres[static_cast<size_t>(a)], spheres[static_cast<size_t>(b)])) {
    pairs.push_back({std::min(a, b), std::max(a, b)});
  }
}

// The ends of a box around [x - r, x + r] in floats that leave nothing out: rounded once to double, once to float and
// then outwards, which is farther than both can have gone inwards.
inline float float_below(double x) {
  return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
}
inline float float_above(double x) {
  return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

// Those that this build has, see CMakeLists.txt. All are three-dimensional and run on one thread.
std::vector<Peer> all_peers();

void add_boost_rtree(std::vector<Peer> &peers);
void add_bullet(std::vector<Peer> &peers);
void add_cgal(std::vector<Peer> &peers);
void add_embree(std::vector<Peer> &peers);
void add_lammps(std::vector<Peer> &peers);
void add_nanoflann(std::vector<Peer> &peers);

}  // namespace bench
