// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A plain loop over candidates that compares boxes before spheres.
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
Candidates candidates_of(const particles::ParticleSet &input);

// As filter_pairs, but boxes are compared first. Returns how many candidates were tested as spheres.
size_t filter_boxes_first(const Candidates &candidates, std::vector<hg_pair> &pairs);

}  // namespace accuracy
