// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What every setup must fulfil.
#include "dem/setup/setup.hpp"

#include "dem/base/error.hpp"
#include "dem/effects/table.hpp"
#include "dem/setup/materials.hpp"

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
  require_length("materials", setup.material_ids.size(), has(setup.effects, kMaterials) ? setup.count() : 0);
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
  for (int axis = 0; axis < setup.dimension; axis++) {
    any_walled |= setup.walled[axis];
    any_periodic |= setup.periodic[axis];
    if (setup.walled[axis] && setup.periodic[axis]) {
      throw Error(std::string("axis ") + "xyz"[axis] + " is periodic: it cannot have walls too");
    }
    const bool bounded = setup.walled[axis] || setup.periodic[axis];
    if (bounded &&
        !(setup.box_max[axis] > setup.box_min[axis] && std::isfinite(setup.box_max[axis] - setup.box_min[axis]))) {
      throw Error(std::string("the box reaches from ") + text(setup.box_min[axis]) + " to " +
                  text(setup.box_max[axis]) + " on axis " + "xyz"[axis]);
    }
  }
  if (any_walled != has(setup.effects, kWalls) || any_periodic != has(setup.effects, kPeriodic)) {
    throw Error("the walled and periodic axes do not agree with the effects " + names_of(setup.effects));
  }
  if (setup.walls.empty() == has(setup.effects, kSurfaces)) {
    throw Error("there are " + std::to_string(setup.walls.size()) +
                " walls beside the box's, which does not agree with " + "the effects " + names_of(setup.effects));
  }
}

}  // namespace

void check_setup(const Setup &setup) {
  if (setup.dimension != 2 && setup.dimension != 3) {
    throw Error("the dimension is 2 or 3, not " + std::to_string(setup.dimension));
  }
  check_physics(setup);
  check_particles(setup);
  check_axes(setup);
  if (has(setup.effects, kMaterials)) check_materials(setup);
  if (setup.level_count < 0) throw Error("the number of levels is " + std::to_string(setup.level_count) + ", below 0");
  if (!(setup.skin >= 0)) throw Error("the skin is 0 or above, not " + text(setup.skin));
}

Setup without_particles(const Setup &setup) {
  Setup result = setup;
  static_cast<ParticleArrays &>(result) = {};
  result.beginning.pairs = result.beginning.walls = {};
  return result;
}

}  // namespace dem
