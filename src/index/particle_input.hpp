// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What the kernels of building read of particles.
#pragma once

#include "src/index/index.hpp"
#include "src/particles/particle_store.hpp"

namespace hg {

// For an index whose map and interaction are set.
inline ParticleInput particle_input(const ParticleStore &store, const Index &index) {
  return {store.centers(), store.radii(), store.summary().center, index.map, index.interaction.folded_radius(0)};
}

}  // namespace hg
