// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// All forces and torques of one contact, between two particles or of a particle with a wall.
#pragma once

#include "dem/effects/contact_law.hpp"
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
};

template <int D, class Real>
struct History {
  Remembered<D, Real> before, now;
  size_t next = 0;  // among those before

  // A pass over all pairs begins.
  void begin_pass() {
    std::swap(before, now);
    now.places.clear();
    for (auto &rows : now.rows) rows.clear();
    next = 0;
  }

  // The pair at this place touches: its rows, those of the pass before or 0, are the last of `now`.
  template <EffectSet E>
  void meet(uint32_t place) {
    while (next < before.places.size() && before.places[next] < place) next++;
    const bool known = next < before.places.size() && before.places[next] == place;
    now.places.push_back(place);
    for_rows<E>(
        [&](size_t k) { now.rows[k].push_back(known ? before.rows[k][next] : Vec<D, Real>(Vec<D, Real>::Zero())); });
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
  // While the surfaces slide, spring and dashpot bear the limit together, so the spring follows at the rate that the
  // dashpot allows. Were it put where it bears the limit alone, a contact would be wound up further than it has moved,
  // and gain energy.
  const Real size = force.norm();
  const bool slides = size > limit;
  const Real borne[2] = {1, limit / size};
  force *= borne[slides];
  const Real firmness = damping + stiffness * step;
  Vec<D, Real> followed[2] = {stretched, stretch};  // no branch: which contacts slide cannot be foreseen
  if (firmness > 0) followed[1] = (damping * stretch - step * force) / firmness;
  stretch = followed[slides];
  return force;
}

// The stiffness of the spring whose stretch an effect remembers, over that of the normal spring.
template <class Real>
constexpr Real stiffness_ratio(const ContactLaw<Real> &law, Effect effect) {
  return effect == kFriction ? law.tangential_ratio : effect == kRolling ? law.rolling_ratio : Real(0);
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
  // Luding, Granul. Matter 10 (2008) 235, sections 2.3 and 2.4; friction, rolling: springs in the tangent plane.
  if constexpr (has(E, kFriction)) {
    const Vec<D, Real> surface_velocity = contact.velocity + turn<D, Real>(contact.turning, contact.normal);
    const Vec<D, Real> along = surface_velocity - contact.normal * contact.normal.dot(surface_velocity);
    const Vec<D, Real> tangential =
        slider_force<D>(history->row(kFriction), contact.normal, along, step, law.tangential_ratio * normal.stiffness,
                        law.tangential_ratio * normal.damping, law.friction * normal.spring);
    result.force += tangential;
    result.moment = moment<D, Real>(contact.normal, tangential);
  }
  if constexpr (has(E, kRolling)) {
    const Real radius = 1 / contact.inverse_radius;
    const Vec<D, Real> turning = radius * turn<D, Real>(contact.spin, contact.normal);
    const Vec<D, Real> resistance =
        slider_force<D>(history->row(kRolling), contact.normal, turning, step, law.rolling_ratio * normal.stiffness,
                        law.rolling_ratio * normal.damping, law.rolling * normal.spring);
    result.rolling = radius * moment<D, Real>(contact.normal, resistance);
  }
  return result;
}

}  // namespace dem
