// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// All forces and torques of one contact, between two particles or of a particle with a wall.
#pragma once

#include "dem/effects/contact_law.hpp"

namespace dem {

// A contact of body a with partner b; `normal` points from a to b.
template <int D, class Real>
struct Contact {
  Vec<D, Real> normal;
  Meeting<Real> meeting;
  Vec<D, Real> velocity;                          // of a relative to b (dissipation, friction)
  Vec<D, Real> surface_velocity;                  // that of a's surface point relative to b's (friction)
  Spin<D, Real> spin;                             // of a relative to b (rolling)
  Real step;                                      // time that the springs with memory advance
  Vec<D, Real> *slip = nullptr, *roll = nullptr;  // their memory
};

// On a; b gets the opposite force, `moment` times its own arm, and the opposite rolling torque.
template <int D, class Real>
struct Effort {
  Vec<D, Real> force;
  Spin<D, Real> moment;   // normal x tangential force: a torque per arm (friction)
  Spin<D, Real> rolling;  // (rolling)
};

template <EffectSet E, int D, class Real>
Effort<D, Real> contact_effort(const ContactLaw<Real> &law, Contact<D, Real> &contact) {
  Effort<D, Real> effort;
  if constexpr (has(E, kDissipation)) contact.meeting.closing_speed = contact.velocity.dot(contact.normal);
  const NormalForce<Real> normal = normal_force<E>(law, contact.meeting);
  effort.force = -normal.value * contact.normal;
  if constexpr (has(E, kFriction)) {
    // Luding, Granul. Matter 10 (2008) 235, sections 2.3 and 2.4; friction, rolling: springs in the tangent plane.
    const Vec<D, Real> along = contact.surface_velocity - contact.normal * contact.normal.dot(contact.surface_velocity);
    const Vec<D, Real> tangential =
        slider_force<D>(*contact.slip, contact.normal, along, contact.step, law.tangential_ratio * normal.stiffness,
                        law.tangential_ratio * normal.damping, law.friction * normal.spring);
    effort.force += tangential;
    effort.moment = moment<D, Real>(contact.normal, tangential);
    if constexpr (has(E, kRolling)) {
      const Real radius = 1 / contact.meeting.inverse_radius;
      const Vec<D, Real> turning = radius * turn<D, Real>(contact.spin, contact.normal);
      const Vec<D, Real> resistance =
          slider_force<D>(*contact.roll, contact.normal, turning, contact.step, law.rolling_ratio * normal.stiffness,
                          law.rolling_ratio * normal.damping, law.rolling * normal.spring);
      effort.rolling = radius * moment<D, Real>(contact.normal, resistance);
    }
  }
  return effort;
}

}  // namespace dem
