// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What every setup must fulfil.
#include "dem/setup/setup.hpp"

#include "dem/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace dem {
namespace {

void require_length(const char *what, size_t length, size_t wanted) {
  if (length != wanted) {
    throw Error(std::string(what) + ": " + std::to_string(length) + " numbers where " + std::to_string(wanted) +
                " are needed");
  }
}

void require_finite(const char *what, const std::vector<double> &numbers, size_t per_particle) {
  for (size_t k = 0; k < numbers.size(); k++) {
    if (!std::isfinite(numbers[k])) {
      throw Error(std::string(what) + " of particle " + std::to_string(k / per_particle) + " is " + text(numbers[k]));
    }
  }
}

void check_particles(const Setup &setup) {
  const auto dimension = static_cast<size_t>(setup.dimension);
  const size_t spin_size = dimension == 3 ? 3 : 1;
  require_length("centers", setup.centers.size(), dimension * setup.count());
  require_length("velocities", setup.velocities.size(), dimension * setup.count());
  require_length("masses", setup.masses.size(), setup.count());
  if (!setup.spins.empty()) require_length("spins", setup.spins.size(), spin_size * setup.count());
  require_finite("the centre", setup.centers, dimension);
  require_finite("the velocity", setup.velocities, dimension);
  require_finite("the spin", setup.spins, spin_size);
  require_finite("the radius", setup.radii, 1);
  for (size_t i = 0; i < setup.count(); i++) {
    if (!(setup.radii[i] > 0)) {
      throw Error("the radius of particle " + std::to_string(i) + " is " + text(setup.radii[i]) + ", not above 0");
    }
    if (!(setup.masses[i] > 0)) {
      throw Error("the mass of particle " + std::to_string(i) + " is " + text(setup.masses[i]) + ", not above 0");
    }
  }
}

void check_axes(const Setup &setup) {
  bool any_walled = false, any_periodic = false;
  for (int k = 0; k < setup.dimension; k++) {
    any_walled |= setup.walled[k];
    any_periodic |= setup.periodic[k];
    if (setup.walled[k] && setup.periodic[k]) {
      throw Error(std::string("axis ") + "xyz"[k] + " is periodic: it cannot have walls too");
    }
    const bool bounded = setup.walled[k] || setup.periodic[k];
    if (bounded && !(setup.box_max[k] > setup.box_min[k] && std::isfinite(setup.box_max[k] - setup.box_min[k]))) {
      throw Error(std::string("the box reaches from ") + text(setup.box_min[k]) + " to " + text(setup.box_max[k]) +
                  " on axis " + "xyz"[k]);
    }
  }
  if (any_walled != has(setup.effects, kWalls) || any_periodic != has(setup.effects, kPeriodic)) {
    throw Error("the walled and periodic axes do not agree with the effects " + names_of(setup.effects));
  }
  if (has(setup.effects, kShear) && !(setup.periodic[0] && setup.periodic[1])) {
    throw Error("shear needs the periodic axes x and y");
  }
}

}  // namespace

void check_setup(const Setup &setup) {
  if (setup.dimension != 2 && setup.dimension != 3) {
    throw Error("the dimension is 2 or 3, not " + std::to_string(setup.dimension));
  }
  require_possible(setup.effects);
  check_particles(setup);
  check_axes(setup);
  if (has(setup.effects, kDrag) && !(setup.viscosity >= 0)) {
    throw Error("the viscosity is 0 or above, not " + text(setup.viscosity));
  }
  // Shrinking particles would get lighter, and collisions shorter than the time step reckons with.
  if (has(setup.effects, kGrowth) && !(setup.growth_rate >= 0)) {
    throw Error("the rate of growth is 0 or above, not " + text(setup.growth_rate));
  }
  if (setup.level_count < 0) throw Error("the number of levels is " + std::to_string(setup.level_count) + ", below 0");
  if (!(setup.skin >= 0)) throw Error("the skin is 0 or above, not " + text(setup.skin));
}

}  // namespace dem
