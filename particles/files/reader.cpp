// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reading particles from a file of any known format.
#include "particles/files/reader.hpp"

#include "particles/error.hpp"
#include "particles/files/readers.hpp"
#include "particles/text/text_file.hpp"

namespace particles {
namespace {

Format recognise(const TextFile &file, const ReadOptions &options) {
  if (options.format) return *options.format;
  if (const std::optional<Format> by_content = format_of_content(file.text)) return *by_content;
  return format_of_name(file.name).value_or(Format::kCsv);
}

ParticleSet read_as(Format format, const TextFile &file, const ReadOptions &options) {
  switch (format) {
    case Format::kCsv:
      return read_csv(file, options);
    case Format::kLammps:
      return read_lammps(file, options);
    case Format::kXyz:
      return read_xyz(file, options);
  }
  throw Error(file.name, 0, "the format is unknown");
}

}  // namespace

ParticleSet read_particles(const std::string &path, const ReadOptions &options) {
  const TextFile file = load_text(path);
  ParticleSet particles = read_as(recognise(file, options), file, options);
  for (int axis = particles.dimension; axis < 3; axis++) {
    particles.box_min[axis] = particles.box_max[axis] = 0;
    particles.periodic[axis] = 0;
  }
  return particles;
}

}  // namespace particles
