// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Options of every command that reads particles: the file, its format, and the box it is searched in.
#pragma once

#include "particles/particle_set.hpp"

#include <string>

namespace CLI {
class App;
}

namespace command {

struct ParticleOptions {
  std::string file;
  std::string format;       // "": recognise it
  long frame = 0;           // 0: the last
  int dimension = 0;        // 0: as the file says
  std::string header;       // names of the columns with commas; empty: the file's
  std::string radius;       // the column of the radius, or a number
  std::string diameter;     // the column of the diameter
  std::string type_radius;  // TYPE=RADIUS with commas
  bool ids = false;         // not an option: whether ids and types are read, too
  bool types = false;
  bool motion = false;   // nor this: velocities
  std::string periodic;  // letters of the periodic axes, "" = as the file says
  bool open = false;     // no periodic axis, whatever the file says
  std::string box;       // lower corner, upper corner with commas; empty: the file's
  std::string tilt;      // xy, xz, yz with commas; empty: the file's, of a box that is given none
};

// Adds FILE, --format, --frame, --dimension, --header, --radius, --diameter, --type-radius, --periodic, --open, --box
// and --tilt. `options` must outlive the parse.
void add_particle_options(CLI::App &command, ParticleOptions &options);

// Reads the file and applies the options for the box.
particles::ParticleSet load_particles(const ParticleOptions &options);

}  // namespace command
