// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a simulation starts from: particles, box, physics and numbers, the dimension not yet fixed at compile time.
#pragma once

#include "dem/effects/effects.hpp"
#include "dem/setup/beginning.hpp"
#include "dem/setup/scheme.hpp"
#include "dem/setup/wall_body.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dem {

constexpr double kImmovable = kInfinity;  // the mass of such a particle

struct ParticleArrays {
  std::vector<double> centers, velocities;  // [count][dimension]
  std::vector<double> radii, masses;        // [count], > 0; masses may be kImmovable
  std::vector<double> spins;                // [count][3] in three dimensions, [count] in two; empty: at rest (friction)
  std::vector<uint8_t> material_ids;        // [count], places in Physics::materials (materials)

  size_t count() const { return radii.size(); }
};

struct Setup : Physics, ParticleArrays {
  int dimension = 3;
  double box_min[3]{}, box_max[3]{};
  std::vector<WallBody> walls;  // beside those of the box (surfaces)
  double time_step = 0;
  Scheme scheme = velocity_verlet();
  int threads = 1;      // 0: all that the machine offers. Results do not depend on it
  int level_count = 0;  // levels of the library's grid at most, 0: as many as are best. Changes the time only
  double skin = 0;      // of the library's stored candidates: changes the time, not the results
  Beginning beginning;
};

// Throws Error naming what cannot be and its value; the time step is looked at by time_step.hpp.
void check_setup(const Setup &setup);

}  // namespace dem
