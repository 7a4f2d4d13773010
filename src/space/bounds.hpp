// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The extents of what is stored.
#pragma once

#include "src/exact/domain.hpp"
#include "src/particles/particle_store.hpp"

namespace hg {

struct Bounds {
  double min[3] = {0, 0, 0};  // of the centres' positions (Domain::position): 0 and the length on periodic axes
  double max[3] = {0, 0, 0};
  double width[3] = {0, 0, 0};  // of the space that the particles themselves take; of the box where one is given
  double max_radius = 0;
};

// The same whatever the number of threads.
Bounds bounds_of(const ParticleStore &store, const Domain &domain, int threads);

}  // namespace hg
