// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Oblique impacts of a rough sphere on a wall, for the tests of friction.
#pragma once

#include "programs/accuracy/simulation/oblique_impact.hpp"
#include "tests/dem/bodies.hpp"

#include <cstddef>

namespace oblique {

using accuracy::Impact;
using accuracy::Motion;

inline dem::Setup rough_hertz(double young, double poisson, double restitution, double friction) {
  dem::Setup setup;
  setup.effects = dem::kHertz | dem::kDissipation | dem::kFriction;
  setup.contact.young_modulus = young;
  setup.contact.poisson_ratio = poisson;
  setup.contact.restitution = restitution;
  setup.contact.friction = friction;
  return setup;
}

inline dem::Setup rough_linear(double stiffness, double tangential_ratio, double restitution, double friction) {
  dem::Setup setup;
  setup.effects = dem::kFriction;
  bodies::set_linear(setup, stiffness, restitution);
  setup.contact.tangential_stiffness = tangential_ratio;
  setup.contact.friction = friction;
  return setup;
}

inline dem::Setup against_wall(dem::Setup law, const Impact &impact) {
  bodies::set_walls(law, 0, 0, 100 * impact.radius);
  bodies::add(law, {1.001 * impact.radius, 0, 0}, {-impact.normal, impact.tangential, 0}, impact.radius, impact.mass,
              {0, 0, impact.spin});
  law.impact_speed = impact.normal;
  return law;
}

inline Motion rebound_of(dem::Setup setup, double steps_per_contact) {
  bodies::set_steps_per_contact(setup, steps_per_contact);
  const auto longest = static_cast<size_t>(20 * steps_per_contact);
  const dem::Snapshot after = bodies::follow_collision(setup, longest).after;
  return {after.velocities[0], after.velocities[1], after.spins[2]};
}

}  // namespace oblique
