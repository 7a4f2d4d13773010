// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a simulation starts from: particles, box, laws and numbers, the dimension not yet fixed at compile time.
#pragma once

#include "dem/effects/contact_law.hpp"
#include "dem/effects/effects.hpp"
#include "dem/setup/scheme.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace dem {

constexpr double kImmovable = std::numeric_limits<double>::infinity();  // the mass of such a particle

// Any consistent units. Members of effects that are off mean nothing.
struct Setup {
  int dimension = 3;
  EffectSet effects = 0;
  ContactParameters contact;

  std::vector<double> centers, velocities;  // [count][dimension]
  std::vector<double> radii, masses;        // [count], > 0; masses may be kImmovable
  std::vector<double> spins;                // [count][3] in three dimensions, [count] in two; empty: at rest (friction)

  double box_min[3]{}, box_max[3]{};
  bool walled[3]{}, periodic[3]{};  // per axis, at most one of them

  double gravity[3]{};
  double viscosity = 0;    // of the fluid: Stokes drag 6 pi eta r v (drag)
  double growth_rate = 0;  // of all radii relative to those at the start, per time (growth)
  double growth_end = std::numeric_limits<double>::infinity();  // time when growth stops
  double shear_rate = 0;                                        // du_x / dy (shear)
  double impact_speed = 0;  // the fastest approach to reckon with; 0: that of the initial velocities (hertz)

  double time_step = 0;
  Scheme scheme = velocity_verlet();
  int threads = 1;      // 0: all that the machine offers. Results do not depend on it
  int level_count = 0;  // levels of the library's grid at most, 0: as many as are best. Changes the time only
  double skin = 0;      // of the library's stored candidates: changes the time, not the results

  size_t count() const { return radii.size(); }
};

// Throws Error naming what cannot be and its value; the time step is looked at by time_step.hpp.
void check_setup(const Setup &setup);

}  // namespace dem
