// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// An elastic gas of spheres of radius 1 to measure on.
#pragma once

#include "dem/setup/setup.hpp"

#include <cstddef>
#include <cstdint>

namespace accuracy {

struct GasCase {
  size_t edge = 5;         // spheres along each axis of the lattice that they start from
  double density = 0.2;    // share of the box that they fill, below pi / 6
  double overlap = 0.01;   // of two spheres of mass 1 on average, over the radius
  double mass_spread = 0;  // masses are uniform in [1, 1 + mass_spread], so contacts last any number of steps
  bool periodic = true;    // else between walls
  uint64_t seed = 1;
};

// At rest as a whole; scheme, time step and skin are left to the caller.
dem::Setup elastic_gas(const GasCase &what);

// The same after 20 t_c, when the spheres have left the lattice and collide.
dem::Setup melted_gas(const GasCase &what);

// About `count` equal spheres between walls, as dense as a liquid: to be timed. So many are enough to forget the work
// per step.
constexpr size_t kTimedGasCount = 4096;
GasCase timed_gas(size_t count);

// kT at which two spheres of mass 1 meet with the flux-weighted mean speed sqrt(pi kT) that lets them overlap so.
double temperature_of(const GasCase &what);

// How often a sphere is met, by kinetic theory: 4 n sigma^2 g sqrt(pi kT / m), with sqrt(1 / m) averaged over pairs and
// g of Carnahan and Starling, J. Chem. Phys. 51 (1969) 635. Per sphere and unit of time.
double collision_rate(const GasCase &what, const dem::Setup &gas);

}  // namespace accuracy
