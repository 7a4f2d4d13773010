// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Writing particles to a file of any known format.
#include "particles/files/writer.hpp"

#include "particles/files/writers.hpp"
#include "particles/text/output.hpp"

namespace particles {

void write_particles(const std::string &path, Format format, const ParticleSet &particles) {
  // Before the file is opened: what it held must not be lost for nothing.
  if (format == Format::kXyz) require_xyz_box(path, particles);
  Output out(path);
  switch (format) {
    case Format::kCsv:
      write_csv(out, particles);
      break;
    case Format::kLammps:
      write_lammps(out, particles);
      break;
    case Format::kXyz:
      write_xyz(out, particles);
      break;
  }
  out.close();
}

}  // namespace particles
