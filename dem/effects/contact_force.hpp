// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// All forces and torques of one contact, between two particles or of a particle with a wall.
#pragma once

#include "dem/effects/contact_law.hpp"
#include "dem/effects/rubbing.hpp"
#include "dem/effects/table.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace dem {

// A contact of body a with partner b; `normal` points from a to b.
template <int D, class Real>
struct Contact : NormalContact<Real> {
  Vec<D, Real> normal;
  Vec<D, Real> velocity;  // of a relative to b (dissipation, friction)
  Spin<D, Real> turning;  // arm x spin, of a and b together (friction)
  Spin<D, Real> spin;     // of a relative to b (rolling)
};

// What contacts remember. Pairs are looked at in ascending order of their places in a list; so the contacts of the pass
// before and those of this one are two lists in the same order, which are gone through side by side.
template <int D, class Real>
struct Remembered {
  std::vector<uint32_t> places;
  std::array<std::vector<Vec<D, Real>>, kHistoryCount> rows;  // by history_of(effect); empty without the effect

  // Keeps its memory.
  void clear() {
    places.clear();
    for (auto &contacts : rows) contacts.clear();
  }
};

template <int D, class Real>
struct History {
  Remembered<D, Real> before, now;
  size_t next = 0;  // among those before

  // A pass over all pairs begins.
  void begin_pass() {
    std::swap(before, now);
    now.clear();
    next = 0;
  }

  // Where the pair at this place, behind those asked for, stands among those before; else as many as they are.
  size_t find(uint32_t place) {
    while (next < before.places.size() && before.places[next] < place) next++;
    return next < before.places.size() && before.places[next] == place ? next : before.places.size();
  }

  // The pair at this place touches: its rows, those of the pass before or 0, are the last of `now`.
  template <EffectSet E>
  void meet(uint32_t place) {
    const size_t former = find(place);
    const bool known = former < before.places.size();
    now.places.push_back(place);
    for_rows<E>(
        [&](size_t k) { now.rows[k].push_back(known ? before.rows[k][former] : Vec<D, Real>(Vec<D, Real>::Zero())); });
  }

  Vec<D, Real> &row(Effect effect) { return now.rows[history_of(effect)].back(); }

 private:
  template <EffectSet E, class Visit>
  static void for_rows(Visit visit) {
    if constexpr (has(E, kFriction)) visit(history_of(kFriction));
    if constexpr (has(E, kRolling)) visit(history_of(kRolling));
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
  if constexpr (has(E, effects_with_history())) history->template meet<E>(static_cast<uint32_t>(p));
  if constexpr (has(E, kDissipation)) contact.closing_speed = contact.velocity.dot(contact.normal);
  const NormalForce<Real> normal = normal_force<E, Real>(law, contact);
  result.force = -normal.value * contact.normal;
  if constexpr (has(E, kFriction)) {
    Vec<D, Real> tangential;
    rub<D>(friction_slider(law, normal), contact.normal.data(), contact.velocity.data(), contact.turning.data(), step,
           history->row(kFriction).data(), tangential.data(), result.moment.data());
    result.force += tangential;
  }
  if constexpr (has(E, kRolling)) {
    roll<D>(rolling_slider(law, normal), contact.normal.data(), contact.spin.data(), 1 / contact.inverse_radius, step,
            history->row(kRolling).data(), result.rolling.data());
  }
  return result;
}

}  // namespace dem
