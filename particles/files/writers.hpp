// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// One writer for each format, called by write_particles.
#pragma once

#include "particles/particle_set.hpp"
#include "particles/text/output.hpp"

#include <string>

namespace particles {

// Begins the comment line of a CSV file that holds the box: lower corner, upper corner, "periodic" and three flags.
constexpr char kBoxComment[] = "# box:";

void write_csv(Output &out, const ParticleSet &particles);
void write_lammps(Output &out, const ParticleSet &particles);

void write_xyz(Output &out, const ParticleSet &particles);

// Throws Error for `path` if a periodic box does not survive in extended XYZ, which stores a corner and edges.
void require_xyz_box(const std::string &path, const ParticleSet &particles);

}  // namespace particles
