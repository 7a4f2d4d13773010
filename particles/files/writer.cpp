// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Writing particles to a file of any known format.
#include "particles/files/writer.hpp"

#include "particles/error.hpp"
#include "particles/text/output.hpp"

namespace particles {

void write_particles(const std::string &path, const Format &format, const ParticleSet &particles) {
  // Before the file is opened: what it held must not be lost for nothing.
  const std::string loss = format.loss(particles);
  if (!loss.empty()) throw Error(path, 0, loss);
  write_picture(path, format, particles);
}

void write_picture(const std::string &path, const Format &format, const ParticleSet &particles) {
  Output out(path);
  format.write(out, particles);
  out.close();
}

}  // namespace particles
