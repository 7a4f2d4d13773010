// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// All forces and torques of one contact, between two particles or of a particle with a wall.
#pragma once

#include "dem/base/large_array.hpp"
#include "dem/base/row.hpp"
#include "dem/effects/contact_law.hpp"
#include "dem/effects/rubbing.hpp"
#include "dem/effects/table.hpp"

#include <array>
#include <cstddef>

namespace dem {

// A contact of body a with partner b; `normal` points from a to b.
template <int D, class Real>
struct Contact : NormalContact<Real> {
  Vec<D, Real> normal;
  Vec<D, Real> velocity;  // of a relative to b (dissipation, friction)
  Spin<D, Real> turning;  // arm x spin, of a and b together (friction)
  Spin<D, Real> spin;     // of a relative to b (rolling)
};

// What the contacts of a part of a list of pairs remember: a row at the place of each pair, beside it the pass over the
// part that the contact was last there in. It goes on from the pass before, else with nothing.
template <int D, class Real>
struct History {
  size_t first = 0;                                         // place in the list
  Real pass = 0;                                            // only states in double remember: 2^53 passes
  std::array<LargeArray<Row<Real>>, kHistoryCount> rows{};  // by history_of(effect); empty without the effect

  void begin_pass() { pass++; }

  Row<Real> &row(Effect effect, size_t place) { return rows[history_of(effect)][place - first]; }
  bool was_there(const Row<Real> &row) const { return row.numbers[3] == pass - 1; }

  // The pair at this place touches: what it remembers, to go on with.
  Real *meet(Effect effect, size_t place) {
    Row<Real> &met = row(effect, place);
    if (!was_there(met)) met = {};
    met.numbers[3] = pass;
    return met.numbers;
  }
};

// On a; b gets the opposite force, `moment` times its own arm, and the opposite rolling torque.
template <int D, class Real>
struct ContactForce {
  Vec<D, Real> force;
  Spin<D, Real> moment;   // normal x tangential force: a torque per arm (friction)
  Spin<D, Real> rolling;  // (rolling)
};

// The stiffness of the spring whose stretch an effect remembers, over that of the normal spring.
template <class Real>
constexpr Real stiffness_ratio(const ContactLaw<Real> &law, Effect effect) {
  return effect == kFriction ? law.tangential_ratio : effect == kRolling ? law.rolling_ratio : Real(0);
}

template <class Real>
Slider<Real> friction_slider(const ContactLaw<Real> &law, const NormalForce<Real> &normal) {
  return {law.tangential_ratio * normal.stiffness, law.tangential_ratio * normal.damping, law.friction * normal.spring};
}
template <class Real>
Slider<Real> rolling_slider(const ContactLaw<Real> &law, const NormalForce<Real> &normal) {
  return {law.rolling_ratio * normal.stiffness, law.rolling_ratio * normal.damping, law.rolling * normal.spring};
}

// The force of the contact at place p of its list; `step`: the time since the forces of the pass before. `inline`,
// since else compilers find it too large to expand into the kernels.
template <EffectSet E, int D, class Real>
inline ContactForce<D, Real> contact_force(const ContactLaw<Real> &law, Contact<D, Real> &contact,
                                           History<D, Real> *history, Real step, size_t p) {
  ContactForce<D, Real> result;
  if constexpr (has(E, kDissipation)) contact.closing_speed = contact.velocity.dot(contact.normal);
  const NormalForce<Real> normal = normal_force<E, Real>(law, contact);
  result.force = -normal.value * contact.normal;
  if constexpr (has(E, kFriction)) {
    Vec<D, Real> tangential;
    rub<D>(friction_slider(law, normal), contact.normal.data(), contact.velocity.data(), contact.turning.data(), step,
           history->meet(kFriction, p), tangential.data(), result.moment.data());
    result.force += tangential;
  }
  if constexpr (has(E, kRolling)) {
    roll<D>(rolling_slider(law, normal), contact.normal.data(), contact.spin.data(), 1 / contact.inverse_radius, step,
            history->meet(kRolling, p), result.rolling.data());
  }
  return result;
}

}  // namespace dem
