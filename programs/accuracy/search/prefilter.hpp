// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Two plain loops over the same candidates, with and without a comparison of boxes before that of the spheres.
#pragma once

#include "particles/particle_set.hpp"

#include <hgrid/hgrid.h>

#include <cstddef>
#include <vector>

namespace accuracy {

// Pairs of equal spheres near enough that every pair whose boxes overlap is among them, and the particles sorted along
// the search's own order, as a good client would keep them.
struct Candidates {
  particles::ParticleSet particles;
  std::vector<hg_pair> pairs;
};
Candidates candidates_of(const particles::ParticleSet &particles);

// The overlapping ones among the candidates, appended to `pairs`, which is empty. Returns how many candidates were
// tested as spheres: all, or those whose boxes overlap.
size_t overlapping(const Candidates &candidates, std::vector<hg_pair> &pairs);
size_t overlapping_boxes_first(const Candidates &candidates, std::vector<hg_pair> &pairs);

}  // namespace accuracy
