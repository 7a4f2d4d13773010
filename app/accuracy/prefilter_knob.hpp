// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// Whether boxes around the spheres are compared before the spheres themselves.
#ifndef APP_ACCURACY_PREFILTER_KNOB_HPP
#define APP_ACCURACY_PREFILTER_KNOB_HPP

#include "accuracy/trade.hpp"
#include "particles/particle_set.hpp"

#include <hgrid/hgrid.h>

#include <cstddef>
#include <vector>

namespace accuracy {

std::vector<TradePoint> measure_prefilter(const Budget &budget, const Progress &progress);

// The overlapping ones among `candidates`, appended to `pairs`, which is empty. Returns how many candidates were
// tested as spheres: all, or those whose boxes overlap.
std::size_t overlapping(const app::ParticleSet &particles, const std::vector<hg_pair> &candidates,
                        std::vector<hg_pair> &pairs);
std::size_t overlapping_boxes_first(const app::ParticleSet &particles, const std::vector<hg_pair> &candidates,
                                    std::vector<hg_pair> &pairs);

// Pairs of equal spheres near enough that every pair whose boxes overlap is among them, and the particles sorted along
// the search's own order, as a good client would keep them.
struct Candidates {
  app::ParticleSet particles;
  std::vector<hg_pair> pairs;
};
Candidates candidates_of(const app::ParticleSet &particles);

}  // namespace accuracy

#endif
