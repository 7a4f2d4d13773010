// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The contact of one particle with a wall, whatever the wall's shape: what the laws ask of it, and what its force does.
#pragma once

#include "dem/effects/contact_force.hpp"
#include "dem/state/bodies.hpp"

#include <cstddef>

namespace dem {

// What there is to say of particle i, `arm` away from a wall at rest; overlap and normal are the caller's.
template <EffectSet E, int D, class Real>
inline void describe_with_wall(const Bodies<D, Real> &bodies, size_t i, [[maybe_unused]] Real arm,
                               Contact<D, Real> &contact) {
  if constexpr (has(E, kNeedMass)) contact.inverse_mass = bodies.inverse_mass(i);
  if constexpr (has(E, kNeedRadius)) contact.inverse_radius = 1 / bodies.radius(i);
  if constexpr (has(E, kModulus) && has(E, kMaterials)) contact.inverse_length = contact.inverse_radius;
  if constexpr (has(E, kNeedVelocity)) contact.velocity = bodies.velocity(i);
  if constexpr (has(E, kFriction)) contact.turning = arm * bodies.spin(i);
  if constexpr (has(E, kRolling)) contact.spin = bodies.spin(i);
}

template <EffectSet E, int D, class Real>
inline void add_wall_force(Bodies<D, Real> &bodies, size_t i, [[maybe_unused]] Real arm,
                           const ContactForce<D, Real> &on_body) {
  bodies.force(i) += on_body.force;
  if constexpr (has(E, kFriction)) bodies.torque(i) += arm * on_body.moment;
  if constexpr (has(E, kRolling)) bodies.torque(i) += on_body.rolling;
}

}  // namespace dem
