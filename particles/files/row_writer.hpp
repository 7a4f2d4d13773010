// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A row of numbers for each particle, as viewers of particles read it.
#pragma once

#include "particles/particle_set.hpp"
#include "particles/text/output.hpp"

#include <cmath>
#include <cstddef>

namespace particles {

// Three coordinates (z = 0 in two dimensions), the radius and the further columns of particle k. Viewers know no
// infinity: the mass of a particle that nothing moves is written as 0.
inline void write_row(Output &out, const ParticleSet &particles, size_t k) {
  const auto dimension = static_cast<size_t>(particles.dimension);
  const double *center = &particles.centers[k * dimension];
  out << center[0] << ' ' << center[1] << ' ' << (dimension == 3 ? center[2] : 0.0) << ' ' << particles.radii[k];
  for (const Column &column : particles.columns) {
    for (size_t n = k * column.width; n < (k + 1) * column.width; n++)
      out << ' ' << (std::isfinite(column.values[n]) ? column.values[n] : 0.0);
  }
  out << '\n';
}

}  // namespace particles
