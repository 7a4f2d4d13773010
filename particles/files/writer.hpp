// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Writing particles to a file of any known format; every double reads back unchanged.
#pragma once

#include "particles/files/format.hpp"
#include "particles/particle_set.hpp"

#include <string>

namespace particles {

// Writes to `path`; "-" is standard output. Throws Error if the file cannot be written completely, or if the format
// cannot hold the box (extended XYZ stores a corner and lengths, a LAMMPS dump the bounds of a tilted box, so a
// periodic box must survive that). Sets in two dimensions stay so in CSV only; the other formats get z = 0 (read them
// with ReadOptions::dimension = 2).
void write_particles(const std::string &path, const Format &format, const ParticleSet &particles);

// The same for looking at: the box may be another in its last bit.
void write_picture(const std::string &path, const Format &format, const ParticleSet &particles);

}  // namespace particles
