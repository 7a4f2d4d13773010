// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Options of every command that reads particles: the file, its format, and the box it is searched in.
#include "programs/hgrid/particle_options.hpp"

#include "particles/files/reader.hpp"
#include "particles/text/lists.hpp"
#include "particles/text/number.hpp"
#include "programs/hgrid/arguments.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>

namespace command {
namespace {

void apply_box(const std::string &text, particles::ParticleSet &particles) {
  const std::vector<double> corners = number_list("--box", text);
  const auto dimension = static_cast<size_t>(particles.dimension);
  if (corners.size() != 2 * dimension)
    throw CLI::ValidationError("--box", "needs " + std::to_string(2 * dimension) + " numbers for particles in " +
                                            std::to_string(dimension) + " dimensions, got " +
                                            std::to_string(corners.size()));
  for (size_t axis = 0; axis < dimension; axis++) {
    particles.box_min[axis] = corners[axis];
    particles.box_max[axis] = corners[dimension + axis];
  }
  std::fill_n(particles.tilt, 3, 0);
  particles.has_box = true;
}

void apply_tilt(const std::string &text, particles::ParticleSet &particles) {
  if (!particles.has_box) throw CLI::ValidationError("--tilt", "the file holds no box; give one with --box");
  const std::vector<double> tilt = number_list("--tilt", text);
  const size_t needed = particles.dimension == 2 ? 1 : 3;
  if (tilt.size() != needed)
    throw CLI::ValidationError("--tilt", "needs " + std::to_string(needed) + " numbers for particles in " +
                                             std::to_string(particles.dimension) + " dimensions, got " +
                                             std::to_string(tilt.size()));
  std::copy_n(tilt.begin(), needed, particles.tilt);
}

void apply_periodic(const std::string &letters, particles::ParticleSet &particles) {
  if (!particles.has_box) throw CLI::ValidationError("--periodic", "the file holds no box; give one with --box");
  for (int &flag : particles.periodic) flag = 0;
  for (const char letter : letters) {
    const int axis = letter - 'x';
    if (axis < 0 || axis >= particles.dimension)
      throw CLI::ValidationError("--periodic", std::string("'") + letter + "' is no axis of these particles");
    particles.periodic[axis] = 1;
  }
}

std::map<std::string, double, std::less<>> type_radii(const std::string &text) {
  std::map<std::string, double, std::less<>> radii;
  for (const std::string &word : word_list(text)) {
    const size_t sign = word.rfind('=');
    if (sign == std::string::npos || sign == 0)
      throw CLI::ValidationError("--type-radius", particles::in_quotes(word) + " is not TYPE=RADIUS");
    const std::string number = word.substr(sign + 1);
    double radius = 0;
    if (const char *fault = particles::number_fault(number, radius))
      throw CLI::ValidationError("--type-radius", particles::in_quotes(number) + " " + fault);
    if (radius < 0) throw CLI::ValidationError("--type-radius", particles::in_quotes(number) + " is negative");
    if (!radii.emplace(word.substr(0, sign), radius).second)
      throw CLI::ValidationError("--type-radius",
                                 "two radii for the type " + particles::in_quotes(word.substr(0, sign)));
  }
  return radii;
}

// Options for columns that do not tell by their names.
void add_column_options(CLI::App &command, ParticleOptions &options, const std::string &group) {
  command
      .add_option("--header", options.header, "Names of all columns, such as id,x,y,z,radius, instead of the file's")
      ->group(group);
  auto *radius =
      command.add_option("--radius", options.radius, "The column of the radius, or a number for all particles")
          ->group(group);
  auto *diameter =
      command.add_option("--diameter", options.diameter, "The column of the diameter")->group(group)->excludes(radius);
  command
      .add_option("--type-radius", options.type_radius,
                  "Radii by the column type (species, element), such as 1=0.5,2=0.1")
      ->group(group)
      ->excludes(radius)
      ->excludes(diameter);
}

}  // namespace

void add_particle_options(CLI::App &command, ParticleOptions &options) {
  const char *const group = "Particles";
  const std::vector<particles::Format> formats = particles::readable_formats();
  const std::vector<std::string> names = particles::names_of(formats);
  std::string contents;
  for (const particles::Format &format : formats)
    contents += std::string(format.title) + " with " + format.needs + "; ";
  command.add_option("FILE", options.file, "Particles: " + contents + "- for standard input")->required();
  command.add_option("--format", options.format, particles::joined(names, " or ") + ", instead of recognising it")
      ->check(CLI::IsMember(names))
      ->group(group);
  command.add_option("--frame", options.frame, "Which of several frames: 1 is the first; the last if not given")
      ->check(positive_count())
      ->group(group);
  command.add_option("--dimension", options.dimension, "2 leaves out a z that all particles share")
      ->check(CLI::IsMember({2, 3}))
      ->group(group);
  add_column_options(command, options, group);
  command.add_option("--box", options.box, "XMIN,YMIN,ZMIN,XMAX,YMAX,ZMAX instead of the file's box")->group(group);
  command
      .add_option("--tilt", options.tilt,
                  "XY,XZ,YZ instead of the file's: the cell's edges are (lx,0,0), (XY,ly,0), (XZ,YZ,lz)")
      ->group(group);
  auto *periodic =
      command.add_option("--periodic", options.periodic, "The periodic axes, such as xy, instead of the file's")
          ->group(group);
  command.add_flag("--open", options.open, "No periodic axis, whatever the file says")
      ->group(group)
      ->excludes(periodic);
}

particles::ParticleSet load_particles(const ParticleOptions &options) {
  particles::ReadOptions read;
  read.format = particles::format_of_word(options.format);
  read.frame = options.frame;
  read.dimension = options.dimension;
  read.header = word_list(options.header);
  read.radius = options.radius;
  read.diameter = options.diameter;
  read.type_radii = type_radii(options.type_radius);
  read.ids = options.ids;
  read.types = options.types;
  read.motion = options.motion;
  read.needs_box = options.box.empty() && !options.open;
  particles::ParticleSet particles = particles::read_particles(options.file, read);
  // Only who says which axes are periodic knows what is missing.
  if (options.periodic.empty() && !options.open)
    for (const std::string &note : particles.notes)
      std::fprintf(stderr, "hgrid: %s: note: %s\n", options.file.c_str(), note.c_str());
  if (!options.box.empty()) apply_box(options.box, particles);
  if (!options.tilt.empty()) apply_tilt(options.tilt, particles);
  if (!options.periodic.empty()) apply_periodic(options.periodic, particles);
  if (options.open)
    for (int &flag : particles.periodic) flag = 0;
  return particles;
}

}  // namespace command
