// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The system that whole steps are measured on: a scene after a few collisions per particle.
#pragma once

#include "dem/setup/setup.hpp"
#include "programs/bench/dem/stepper.hpp"

#include <cstdint>
#include <string>

namespace bench {

struct Settling {
  double collisions = 5;    // per particle, each counted for both partners
  uint64_t most_steps = 0;  // 0: as many as it takes
};

struct SettledSystem {
  std::string name;  // the scene's file without folder and ending
  dem::Setup setup;  // centres and velocities are the settled ones
  double collisions = 0;
  uint64_t steps = 0;
};

// Sums over a state that all contestants are compared by, from plain code of our own.
struct Sums {
  double kinetic = 0, elastic = 0;
  size_t contacts = 0;  // pairs; walls are in the elastic energy only

  double energy() const { return kinetic + elastic; }
};
Sums sums_of(const dem::Setup &setup, const MotionState &state);

// Reads a scene of elastic spheres between walls and lets it run, in a process of its own, until the particles have
// collided so often. Relaxed packings hold energy in their overlaps: while the kinetic energy is more than a tenth
// above its value at the start, velocities are scaled back. To `keep` means to take the settled state from the file
// SCENE.state if it exists, and else to write it there. Throws std::exception if the scene asks for anything else.
SettledSystem settle(const std::string &scene, const Settling &settling, bool keep);

}  // namespace bench
