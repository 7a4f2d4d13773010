// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// One reader for each format, called by read_particles.
#pragma once

#include "particles/files/reader.hpp"
#include "particles/particle_set.hpp"
#include "particles/text/text_file.hpp"

namespace particles {

// A header names the columns x, y, z (optional) and radius, r, diameter or d, in any order and among others. Separators
// are commas, semicolons, tabs or blanks, as in the header. Lines that begin with '#' are comments; the one that
// write_particles leaves ("# box: ...") sets the box.
ParticleSet read_csv(const TextFile &file, const ReadOptions &options);

// Text dumps with columns x or xu or xs or xsu (and so on) and radius or diameter, in boxes without tilt.
ParticleSet read_lammps(const TextFile &file, const ReadOptions &options);

// Extended XYZ: Properties must name pos and radius (or r, diameter, d); Lattice, pbc and Origin set the box. As usual
// for the format, a Lattice without pbc is periodic on all axes.
ParticleSet read_xyz(const TextFile &file, const ReadOptions &options);

}  // namespace particles
