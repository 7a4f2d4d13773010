// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reading particles from a file of any known format.
#include "particles/files/reader.hpp"

#include "particles/error.hpp"
#include "particles/text/number.hpp"
#include "particles/text/text_file.hpp"

#include <algorithm>
#include <string_view>

namespace particles {
namespace {

std::string first_line(std::string_view text) {
  return in_quotes(text.substr(0, std::min(text.find('\n'), text.size())));
}

[[noreturn]] void fail_unknown(const TextFile &file) {
  std::string message = "neither the content nor the name tells what kind of file this is. Looked for: ";
  for (const Format &format : readable_formats()) message += std::string(format.title) + " with " + format.needs + "; ";
  throw Error(file.name, 1, message + "but it begins with " + first_line(file.text));
}

const Format &recognise(const TextFile &file, const ReadOptions &options) {
  if (options.format != nullptr) return *options.format;
  if (const Format *by_content = format_of_content(file.text)) return *by_content;
  if (const Format *by_name = format_of_name(file.name)) return *by_name;
  if (options.header.empty() && !names_columns(file.text)) fail_unknown(file);
  return *format_of_word("csv");
}

}  // namespace

ParticleSet read_particles(const std::string &path, const ReadOptions &options) {
  const TextFile file = load_text(path);
  const Format &format = recognise(file, options);
  if (format.read == nullptr) throw Error(file.name, 0, std::string(format.title) + " is only written, never read");
  ParticleSet particles = format.read(file, options);
  for (int axis = particles.dimension; axis < 3; axis++) {
    particles.box_min[axis] = particles.box_max[axis] = 0;
    particles.periodic[axis] = 0;
    particles.tilt[1] = particles.tilt[2] = 0;
  }
  return particles;
}

void require_upright(const ParticleSet &particles, const std::string &path) {
  const bool is_open = std::all_of(particles.periodic, particles.periodic + 3, [](int flag) { return flag == 0; });
  if (particles.is_tilted() && !is_open)
    throw Error(path, 0, "the periodic box is tilted, and only boxes along the axes can be used here");
}

}  // namespace particles
