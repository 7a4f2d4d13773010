// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A LAMMPS text dump of one frame with the columns id, type, x, y, z and radius.
#include "particles/files/writers.hpp"

#include <algorithm>

namespace particles {
namespace {

// A dump must have bounds: where the set has no box, those of its particles (boundary "ss", shrink-wrapped).
void bounds_of(const ParticleSet &particles, int axis, double &low, double &high) {
  const auto dimension = static_cast<size_t>(particles.dimension);
  low = high = 0;
  if (axis >= particles.dimension) return;
  for (size_t k = 0; k < particles.count(); k++) {
    const double place = particles.centers[k * dimension + static_cast<size_t>(axis)];
    const double radius = particles.radii[k];
    low = k == 0 ? place - radius : std::min(low, place - radius);
    high = k == 0 ? place + radius : std::max(high, place + radius);
  }
}

}  // namespace

void write_lammps(Output &out, const ParticleSet &particles) {
  out << "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n" << particles.count() << "\nITEM: BOX BOUNDS";
  for (const int flag : particles.periodic) out << (flag ? " pp" : particles.has_box ? " ff" : " ss");
  out << '\n';
  for (int axis = 0; axis < 3; axis++) {
    double low = particles.box_min[axis], high = particles.box_max[axis];
    if (!particles.has_box) bounds_of(particles, axis, low, high);
    out << low << ' ' << high << '\n';
  }
  out << "ITEM: ATOMS id type x y z radius\n";
  const auto dimension = static_cast<size_t>(particles.dimension);
  for (size_t k = 0; k < particles.count(); k++) {
    const double *center = &particles.centers[k * dimension];
    out << k + 1 << " 1 " << center[0] << ' ' << center[1] << ' ' << (dimension == 3 ? center[2] : 0.0) << ' '
        << particles.radii[k] << '\n';
  }
}

}  // namespace particles
