// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// CSV with a header line, below a comment that holds the box.
#include "particles/files/writers.hpp"

namespace particles {

void write_csv(Output &out, const ParticleSet &particles) {
  if (particles.has_box) {
    out << kBoxComment;
    for (const double corner : particles.box_min) out << ' ' << corner;
    for (const double corner : particles.box_max) out << ' ' << corner;
    out << " periodic";
    for (const int flag : particles.periodic) out << ' ' << flag;
    out << '\n';
  }
  const auto dimension = static_cast<size_t>(particles.dimension);
  out << (dimension == 3 ? "x,y,z,radius\n" : "x,y,radius\n");
  for (size_t k = 0; k < particles.count(); k++) {
    for (size_t axis = 0; axis < dimension; axis++) out << particles.centers[k * dimension + axis] << ',';
    out << particles.radii[k] << '\n';
  }
}

}  // namespace particles
