// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Gases of spheres or discs without overlaps, for the tests of the simulation.
#pragma once

#include "packing/random.hpp"
#include "tests/dem/bodies.hpp"

namespace bodies {

struct Gas {
  int dimension = 3;
  size_t edge = 8;     // particles per axis, on a lattice at first
  double spacing = 3;  // of the lattice
  double largest = 1;  // radii are uniform in [0.7, largest] of the lattice's half
  double temperature = 1;
  dem::EffectSet effects = 0;
};

// Particles on a lattice with random velocities, in a box [0, edge spacing] on all axes. Its kind is the caller's.
inline dem::Setup make_gas(const Gas &gas, uint64_t seed) {
  dem::Setup setup;
  setup.dimension = gas.dimension;
  setup.effects = gas.effects;
  set_linear(setup, 1e4);
  packing::Random random(seed);
  const size_t layers = gas.dimension == 3 ? gas.edge : 1;
  for (size_t k = 0; k < layers; k++) {
    for (size_t j = 0; j < gas.edge; j++) {
      for (size_t i = 0; i < gas.edge; i++) {
        const double radius = gas.largest * (0.7 + 0.3 * random.uniform());
        const double mass = radius * radius * radius;
        std::vector<double> center, velocity;
        for (const size_t n : {i, j, k}) {
          if (center.size() == static_cast<size_t>(gas.dimension)) break;
          center.push_back((static_cast<double>(n) + 0.5) * gas.spacing);
          velocity.push_back(std::sqrt(gas.temperature / mass) * random.normal());
        }
        add(setup, center, velocity, radius, mass);
      }
    }
  }
  for (int k = 0; k < gas.dimension; k++) {
    setup.box_min[k] = 0;
    setup.box_max[k] = static_cast<double>(gas.edge) * gas.spacing;
  }
  return setup;
}

inline void wall_in(dem::Setup &setup) {
  for (int k = 0; k < setup.dimension; k++) set_walls(setup, k, setup.box_min[k], setup.box_max[k]);
}

inline void make_periodic(dem::Setup &setup) {
  for (int k = 0; k < setup.dimension; k++) set_periodic(setup, k, setup.box_min[k], setup.box_max[k]);
}

// With the images above moving at `rate` times the edge; velocities are without its profile.
inline dem::Setup make_sheared_gas(Gas gas, double rate, uint64_t seed) {
  gas.effects |= dem::kShear;
  dem::Setup setup = make_gas(gas, seed);
  make_periodic(setup);
  setup.shear_rate = rate;
  set_steps_per_contact(setup, 50);
  return setup;
}

}  // namespace bodies
