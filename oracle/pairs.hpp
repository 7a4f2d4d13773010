// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The answers that the library must give, found pair by pair without it, and how an answer differs from them.
#pragma once

#include "oracle/rule.hpp"
#include "particles/particle_set.hpp"

#include <cstdint>
#include <vector>

namespace oracle {

using Pairs = std::vector<hg_pair>;

inline bool pair_less(const hg_pair &p, const hg_pair &q) { return p.a != q.a ? p.a < q.a : p.b < q.b; }
inline bool pair_equal(const hg_pair &p, const hg_pair &q) { return p.a == q.a && p.b == q.b; }

// Pairs of rows of `particles` as ids (row + index_base), ascending, by looking at every pair. With HG_ALL_IMAGES a
// pair stands there once for each of its images, and rows are pairs with their own images, once for both of opposite
// shifts.
Pairs all_pairs(const hg_grid_def &def, const particles::ParticleSet &particles, Rule *rule);
// The same with ids given, ascending.
Pairs all_pairs(const hg_grid_def &def, const particles::ParticleSet &particles, const std::vector<int32_t> &ids,
                Rule *rule);

// As all_pairs, for systems where that takes too long: only pairs whose extents along x overlap are looked at. Throws
// std::invalid_argument if x is periodic. O(N log N + candidates).
Pairs swept_pairs(const hg_grid_def &def, const particles::ParticleSet &particles, Rule *rule);

// Whether any image of the particle interacts with the sphere.
bool meets(const hg_grid_def &def, const Sphere &sphere, const Sphere &particle, Rule *rule);

// Rows that do so, as ids (row + index_base), ascending.
std::vector<int32_t> all_in_sphere(const hg_grid_def &def, const particles::ParticleSet &particles,
                                   const Sphere &sphere, Rule *rule);

// Whether the periodic cell is so short that two of the particles could be a pair through two images, wherever they
// are: its shortest vector is shorter than twice the longest reach of two particles.
bool can_meet_twice(const hg_grid_def &def, const particles::ParticleSet &particles);

struct Difference {
  Pairs missing, extra;  // ascending
  size_t count() const { return missing.size() + extra.size(); }
};

// `truth` is ascending, `found` in any order. A pair that is found more often than it should be counts as extra.
Difference difference(const Pairs &truth, Pairs found);

// How many images are nearer than the farthest that `found`, ascending, has of a pair. Those of a particle with itself
// come twice, after itself.
size_t nearer_images(const Pairs &found, const hg_pair &pair);

}  // namespace oracle
