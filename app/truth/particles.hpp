// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// Particles of a file or packing as the truth takes them.
#ifndef APP_TRUTH_PARTICLES_HPP
#define APP_TRUTH_PARTICLES_HPP

#include "particles/particle_set.hpp"
#include "truth/exact_set.hpp"

namespace oracle {

// Particles in two dimensions lie in the plane z = 0.
inline Set set_of(const app::ParticleSet &particles) {
  Set set;
  const auto dimension = static_cast<std::size_t>(particles.dimension);
  for (std::size_t i = 0; i < particles.count(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      set.centers.push_back(k < dimension ? particles.centers[i * dimension + k] : 0);
    }
  }
  set.radii = particles.radii;
  for (int k = 0; k < 3; ++k) {
    set.periodic[k] = particles.periodic[k] != 0;
    if (!set.periodic[k]) continue;
    set.box_min[k] = particles.box_min[k];
    set.box_max[k] = particles.box_max[k];
  }
  return set;
}

}  // namespace oracle

#endif
