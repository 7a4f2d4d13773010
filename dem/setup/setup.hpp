// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a simulation starts from: particles, box, physics and numbers, the dimension not yet fixed at compile time.
#pragma once

#include "dem/effects/effects.hpp"
#include "dem/setup/beginning.hpp"
#include "dem/setup/region.hpp"
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
  std::vector<Inflow> inflows;
  std::vector<Region> removals;
  ParticleArrays expected;  // the smallest and the largest of those that may come, twice each: two of them can meet
  double time_step = 0;
  Scheme scheme = velocity_verlet();
  int threads = 1;      // 0: all that the machine offers. Results do not depend on it
  int level_count = 0;  // levels of the library's grid at most, 0: as many as are best. Changes the time only
  double skin = 0;      // of the library's stored candidates: changes the time, not the results
  Beginning beginning;

  // -1: there is none (materials).
  int first_material() const {
    for (const std::vector<uint8_t> *ids : {&material_ids, &expected.material_ids}) {
      if (!ids->empty()) return ids->front();
    }
    return -1;
  }
  bool exchanges() const { return !inflows.empty() || !removals.empty(); }
};

// All particles that there are and then those that are expected: visit(arrays, i). What is reckoned in advance, such as
// the time step, is for both.
template <class Visit>
void visit_particles(const Setup &setup, Visit visit) {
  for (const ParticleArrays *particles : {static_cast<const ParticleArrays *>(&setup), &setup.expected}) {
    for (size_t i = 0; i < particles->count(); i++) visit(*particles, i);
  }
}

// For those who keep the particles and what contacts remember elsewhere.
Setup without_particles(const Setup &setup);

// Throws Error naming what cannot be and its value; the time step is looked at by time_step.hpp.
void check_setup(const Setup &setup);

}  // namespace dem
