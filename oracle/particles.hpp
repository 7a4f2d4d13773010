// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles of a file or packing as the truth takes them.
#pragma once

#include "oracle/exact_set.hpp"
#include "particles/particle_set.hpp"

namespace oracle {

// Particles in two dimensions lie in the plane z = 0.
inline Set set_of(const particles::ParticleSet &particles) {
  Set set;
  const auto dimension = static_cast<size_t>(particles.dimension);
  for (size_t i = 0; i < particles.count(); i++) {
    for (size_t k = 0; k < 3; k++) {
      set.centers.push_back(k < dimension ? particles.centers[i * dimension + k] : 0);
    }
  }
  set.radii = particles.radii;
  for (int k = 0; k < 3; k++) {
    set.periodic[k] = particles.periodic[k] != 0;
    if (!set.periodic[k]) continue;
    set.box_min[k] = particles.box_min[k];
    set.box_max[k] = particles.box_max[k];
  }
  return set;
}

}  // namespace oracle
