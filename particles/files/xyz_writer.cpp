// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Extended XYZ of one frame.
#include "particles/error.hpp"
#include "particles/files/writers.hpp"

#include <string>

namespace particles {
namespace {

void write_box(Output &out, const ParticleSet &particles) {
  const double *low = particles.box_min, *high = particles.box_max;
  out << "Lattice=\"" << high[0] - low[0] << " 0 0 0 " << high[1] - low[1] << " 0 0 0 " << high[2] - low[2] << "\" ";
  out << "Origin=\"" << low[0] << ' ' << low[1] << ' ' << low[2] << "\" ";
}

}  // namespace

void require_xyz_box(const std::string &path, const ParticleSet &particles) {
  for (int axis = 0; axis < 3; axis++) {
    const double low = particles.box_min[axis], high = particles.box_max[axis];
    if (particles.periodic[axis] && low + (high - low) != high)
      throw Error(path, 0,
                  std::string("extended XYZ stores a corner and an edge, which cannot hold the periodic box on axis ") +
                      "xyz"[axis] + " exactly; write CSV or a LAMMPS dump");
  }
}

void write_xyz(Output &out, const ParticleSet &particles) {
  out << particles.count() << '\n';
  if (particles.has_box) write_box(out, particles);
  out << "Properties=species:S:1:pos:R:3:radius:R:1 pbc=\"";
  for (int axis = 0; axis < 3; axis++) out << (axis > 0 ? " " : "") << (particles.periodic[axis] ? 'T' : 'F');
  out << "\"\n";
  const auto dimension = static_cast<size_t>(particles.dimension);
  for (size_t k = 0; k < particles.count(); k++) {
    const double *center = &particles.centers[k * dimension];
    out << "X " << center[0] << ' ' << center[1] << ' ' << (dimension == 3 ? center[2] : 0.0) << ' '
        << particles.radii[k] << '\n';
  }
}

}  // namespace particles
