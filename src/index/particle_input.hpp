// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What the kernels of building read of particles.
#pragma once

#include "src/index/index.hpp"
#include "src/particles/participants.hpp"

namespace hg {

// For an index whose map and interaction are set.
inline ParticleInput particle_input(const Participants &particles, const Index &index) {
  return {
      particles.centers(), particles.radii(), particles.summary().center, index.map, index.interaction.folded_radius(0),
      particles.slots()};
}

}  // namespace hg
