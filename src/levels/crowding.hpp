// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Judges whether a table of cells suits a level, from a sample of its particles.
#pragma once

#include "src/exact/domain.hpp"
#include "src/kernels/kernel.hpp"
#include "src/particles/particle_store.hpp"
#include "src/space/frame.hpp"

namespace hg {

// Radii above `above` and up to `up_to` belong to the level.
struct RadiusRange {
  double above, up_to;
};

// An estimate of how many others share a particle's cell: the mean over particles, not over cells.
double estimate_crowding(const ParticleStore &store, const Domain &domain, const Frame &frame, const CellTable &cells,
                         const RadiusRange &radii, size_t particles);

}  // namespace hg
