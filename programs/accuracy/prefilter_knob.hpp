// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether boxes around the spheres are compared before the spheres themselves.
#pragma once

#include "particles/particle_set.hpp"
#include "programs/accuracy/trade.hpp"

#include <hgrid/hgrid.h>

#include <cstddef>
#include <vector>

namespace accuracy {

std::vector<TradePoint> measure_prefilter(const Budget &budget, const Progress &progress);

// The overlapping ones among `candidates`, appended to `pairs`, which is empty. Returns how many candidates were
// tested as spheres: all, or those whose boxes overlap.
size_t overlapping(const particles::ParticleSet &particles, const std::vector<hg_pair> &candidates,
                   std::vector<hg_pair> &pairs);
size_t overlapping_boxes_first(const particles::ParticleSet &particles, const std::vector<hg_pair> &candidates,
                               std::vector<hg_pair> &pairs);

// Pairs of equal spheres near enough that every pair whose boxes overlap is among them, and the particles sorted along
// the search's own order, as a good client would keep them.
struct Candidates {
  particles::ParticleSet particles;
  std::vector<hg_pair> pairs;
};
Candidates candidates_of(const particles::ParticleSet &particles);

}  // namespace accuracy
