// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reading particles from a file of any known format.
#pragma once

#include "particles/files/format.hpp"
#include "particles/particle_set.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace particles {

struct ReadOptions {
  const Format *format = nullptr;   // nullptr: by content, then by the ending of the name
  long frame = 0;                   // of a file with several: 1 is the first, 0 the last
  int dimension = 0;                // 0: as the file says; 2: leave z out, which must then be the same in all rows
  std::vector<std::string> header;  // the names of the columns, instead of the file's
  std::string radius;               // the column that holds it, or a number: of all particles
  std::string diameter;             // the column that holds it
  std::map<std::string, double, std::less<>> type_radii;  // the radius of each type
  bool needs_box = true;  // false: another box is used, so a cell that no grid takes is passed over
  bool motion = false;    // also velocity, spin, mass, material where there are such columns; names of others
  bool ids = false;       // also the column id
  bool types = false;     // also the column type
};

// Reads `path`; "-" is standard input. Shows progress on a terminal if the file is large.
// Throws Error naming file, line and value if the file is not what it should be.
ParticleSet read_particles(const std::string &path, const ReadOptions &options = {});

// For those who know periodic boxes along the axes only: throws Error naming `path` if this one is tilted.
void require_upright(const ParticleSet &particles, const std::string &path);

}  // namespace particles
