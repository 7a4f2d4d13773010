// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A packing from start to end: radii from a size law, random places, relaxation.
#pragma once

#include "packing/arrangement.hpp"
#include "packing/random.hpp"
#include "packing/relaxation.hpp"
#include "packing/size_law.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace packing {

// The defaults are the paper's uniform-volume system.
struct Request {
  SizeLaw law;
  const Arrangement *arrangement = &arrangements().front();
  size_t count = 125001;
  double density = 0.62;  // volume (2D: area) of the particles over that of what they fill
  uint64_t seed = 1;
  double offset = 0.5;             // u of the systematic sampling, in [0, 1)
  bool random_offset = false;      // u is drawn from the seed instead
  int sweeps = 60;                 // of the even arrangement
  std::array<bool, 3> periodic{};  // of the even arrangement
};

struct Packing {
  particles::ParticleSet particles;  // in random order
  Overlaps overlaps;
};

// Throws particles::Error naming the value that cannot be: a density of 1, a negative number of sweeps ...
void check_request(const Request &request);

// What an even packing is made from.
struct Beginning {
  Box box;
  std::vector<double> radii;  // in random order
  Random random;              // for all that follows
};

// Checks the request, samples the radii and sets up the box. Throws particles::Error also where the box is smaller than
// its largest particle.
Beginning begin_packing(const Request &request);

// An uneven arrangement: places of equal spheres (disks), for which the radii are then drawn without regard to the
// place; space is stretched so that the density stays. Their overlaps stay too.
particles::ParticleSet lay_particles(const Request &request);

// Checks the request and makes the packing. The same request gives the same bytes on any machine.
Packing make_packing(const Request &request, const SweepObserver &observe);

// Multiplies all lengths of a packing, whose box starts at 0.
void scale(particles::ParticleSet &set, double factor);

}  // namespace packing
