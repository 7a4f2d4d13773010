// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// All forces and torques of one contact, between two particles or of a particle with a wall.
#pragma once

#include "dem/effects/contact_law.hpp"
#include "dem/effects/table.hpp"

#include <array>
#include <cstdint>

namespace dem {

// A contact of body a with partner b; `normal` points from a to b.
template <int D, class Real>
struct Contact : NormalContact<Real> {
  Vec<D, Real> normal;
  Vec<D, Real> velocity;  // of a relative to b (dissipation, friction)
  Spin<D, Real> turning;  // arm x spin, of a and b together (friction)
  Spin<D, Real> spin;     // of a relative to b (rolling)
};

// What contacts remember, a row for each pair that may touch, and the time that it advances.
template <int D, class Real>
struct History {
  std::array<Vec<D, Real> *, kHistoryCount> rows;
  uint32_t *met;  // the pass over all contacts in which each pair last touched
  uint32_t pass;  // the present one
  Real step;

  // Pair p touches: what it remembers is of the pass before, or nothing.
  template <EffectSet E>
  void meet(size_t p) const {
    if (met[p] + 1 != pass) {
      for (const EffectRow &row : kEffects) {
        if (row.history != nullptr && has(E, row.effect)) rows[history_of(row.effect)][p].setZero();
      }
    }
    met[p] = pass;
  }

  // That of the pairs from p on.
  History from(size_t p) const {
    History result = *this;
    result.met += p;
    for (Vec<D, Real> *&row : result.rows) {
      if (row != nullptr) row += p;
    }
    return result;
  }
};

// On a; b gets the opposite force, `moment` times its own arm, and the opposite rolling torque.
template <int D, class Real>
struct ContactForce {
  Vec<D, Real> force;
  Spin<D, Real> moment;   // normal x tangential force: a torque per arm (friction)
  Spin<D, Real> rolling;  // (rolling)
};

// Spring and dashpot side by side, in series with the slider of Cundall and Strack: `stretch` is what the spring
// remembers, `velocity` the relative velocity in the tangent plane of `normal`, `limit` the most that the slider bears.
// Returns the force against the motion.
template <int D, class Real>
Vec<D, Real> slider_force(Vec<D, Real> &stretch, const Vec<D, Real> &normal, const Vec<D, Real> &velocity, Real step,
                          Real stiffness, Real damping, Real limit) {
  if (!(limit > 0)) {  // nothing presses the surfaces together: nothing to remember
    stretch.setZero();
    return stretch;
  }
  stretch -= normal * normal.dot(stretch);  // the contact has turned since the last step
  const Vec<D, Real> stretched = stretch + velocity * step;
  Vec<D, Real> force = -stiffness * stretched - damping * velocity;
  const Real size = force.norm();
  if (!(size > limit)) {
    stretch = stretched;
    return force;
  }
  // While the surfaces slide, spring and dashpot bear the limit together, so the spring follows at the rate that the
  // dashpot allows. Were it put where it bears the limit alone, a contact would be wound up further than it has moved,
  // and gain energy.
  force *= limit / size;
  const Real firmness = damping + stiffness * step;
  if (firmness > 0) stretch = (damping * stretch - step * force) / firmness;
  return force;
}

// The stiffness of the spring whose stretch an effect remembers, over that of the normal spring.
template <class Real>
constexpr Real stiffness_ratio(const ContactLaw<Real> &law, Effect effect) {
  return effect == kFriction ? law.tangential_ratio : effect == kRolling ? law.rolling_ratio : Real(0);
}

// The force of contact p; `inline`, since else compilers find it too large to expand into the kernels.
template <EffectSet E, int D, class Real>
inline ContactForce<D, Real> contact_force(const ContactLaw<Real> &law, Contact<D, Real> &contact,
                                           const History<D, Real> &history, size_t p) {
  ContactForce<D, Real> result;
  if constexpr (has(E, effects_with_history())) history.template meet<E>(p);
  if constexpr (has(E, kDissipation)) contact.closing_speed = contact.velocity.dot(contact.normal);
  const NormalForce<Real> normal = normal_force<E, Real>(law, contact);
  result.force = -normal.value * contact.normal;
  // Luding, Granul. Matter 10 (2008) 235, sections 2.3 and 2.4; friction, rolling: springs in the tangent plane.
  if constexpr (has(E, kFriction)) {
    const Vec<D, Real> surface_velocity = contact.velocity + turn<D, Real>(contact.turning, contact.normal);
    const Vec<D, Real> along = surface_velocity - contact.normal * contact.normal.dot(surface_velocity);
    const Vec<D, Real> tangential = slider_force<D>(
        history.rows[history_of(kFriction)][p], contact.normal, along, history.step,
        law.tangential_ratio * normal.stiffness, law.tangential_ratio * normal.damping, law.friction * normal.spring);
    result.force += tangential;
    result.moment = moment<D, Real>(contact.normal, tangential);
  }
  if constexpr (has(E, kRolling)) {
    const Real radius = 1 / contact.inverse_radius;
    const Vec<D, Real> turning = radius * turn<D, Real>(contact.spin, contact.normal);
    const Vec<D, Real> resistance = slider_force<D>(history.rows[history_of(kRolling)][p], contact.normal, turning,
                                                    history.step, law.rolling_ratio * normal.stiffness,
                                                    law.rolling_ratio * normal.damping, law.rolling * normal.spring);
    result.rolling = radius * moment<D, Real>(contact.normal, resistance);
  }
  return result;
}

}  // namespace dem
