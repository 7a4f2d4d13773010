// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The contacts among particles, as the library finds them, and how deep they are.
#pragma once

#include "particles/particle_set.hpp"

#include <hgrid/hgrid.h>

#include <vector>

namespace accuracy {

// The pairs of a grid that is made for this one search.
std::vector<hg_pair> found_pairs(const hg_grid_def &def, const particles::ParticleSet &particles);

// Appends those of the candidates that overlap, by the expression in doubles with which HG_DOUBLE decides. A plain loop
// for three dimensions without periodic axes, to be timed.
void filter_pairs(const particles::ParticleSet &particles, const std::vector<hg_pair> &candidates,
                  std::vector<hg_pair> &pairs);

// The sum of the two radii less the distance to the nearest image.
double overlap_of(const particles::ParticleSet &particles, const hg_pair &pair);
// The same over the smaller of the two radii.
double relative_overlap(const particles::ParticleSet &particles, const hg_pair &pair);

}  // namespace accuracy
