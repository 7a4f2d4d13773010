// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The force of one contact, composed at compile time from the effects of the scene.
//
// Overlap d, closing speed v = -dd'/dt < 0 while the contact opens, reduced mass mu, reduced radius R.
//   linear         F = k d + c sqrt(mu) v       c = -2 ln e sqrt(k / (pi^2 + ln^2 e)): restitution e for every pair
//   Hertz          F = K d^1.5 + a sqrt(mu K) d^0.25 v,  K = 4/3 E* sqrt(R),  a = -sqrt5 ln e / sqrt(pi^2 + ln^2 e):
//                  restitution e at every speed (Antypov & Elliott, EPL 94 (2011) 50004)
//   adhesion       F = k d - F_a for d >= 0, -F_a (1 + d / h) for -h < d < 0: reversible, pull-off force F_a, range h
// Near the end of a damped collision F is negative for a moment. It is left so: only then is the restitution e exactly.
#pragma once

#include "dem/base/vector.hpp"
#include "dem/effects/effects.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

// What a scene says about contacts; members of effects that are off mean nothing.
struct ContactParameters {
  double stiffness = 0;             // k, force per length (linear)
  double restitution = 1;           // e, 0 < e <= 1 (dissipation)
  double friction = 0;              // mu, >= 0
  double tangential_stiffness = 0;  // k_t / k > 0 (linear friction)
  double rolling_friction = 0;      // >= 0
  double rolling_stiffness = 0;     // k_r / k > 0
  double adhesion_force = 0;        // F_a >= 0
  double adhesion_range = 0;        // h > 0
  double young_modulus = 0;         // of the particles (Hertz)
  double poisson_ratio = 0;         // of the particles, -1 < nu <= 0.5
  double wall_young_modulus = 0;    // 0: rigid walls
  double wall_poisson_ratio = 0;
};

enum class Partner { kParticle, kWall };

// The same as numbers that the kernels multiply with.
template <class Real>
struct ContactLaw {
  Real stiffness = 0, damping = 0;
  Real friction = 0, tangential_ratio = 0;  // mu, k_t / k
  Real rolling = 0, rolling_ratio = 0;      // the same of rolling
  Real adhesion_force = 0, inverse_range = 0;
  Real modulus = 0;  // E*
};

template <class Real>
ContactLaw<Real> make_law(const ContactParameters &parameters, EffectSet effects, Partner partner);

// What a contact force depends on besides the overlap.
template <class Real>
struct Meeting {
  Real overlap, closing_speed;
  Real inverse_mass;    // 1/m_a + 1/m_b; 0 if neither can move
  Real inverse_radius;  // 1/r_a + 1/r_b
};

// Normal force and what the tangential force is reckoned from.
template <class Real>
struct NormalForce {
  Real value = 0;      // > 0 repels
  Real spring = 0;     // the spring's part: bounds the friction
  Real damping = 0;    // force per closing speed
  Real stiffness = 0;  // dF/dd
};

template <class Real>
Real reduced_mass(const Meeting<Real> &meeting) {
  return meeting.inverse_mass > 0 ? 1 / meeting.inverse_mass : Real(0);
}

template <EffectSet E, class Real>
NormalForce<Real> normal_force(const ContactLaw<Real> &law, const Meeting<Real> &meeting) {
  NormalForce<Real> force;
  if constexpr (has(E, kAdhesion)) {
    if (meeting.overlap < 0) {
      force.value = -law.adhesion_force * std::max(Real(0), 1 + meeting.overlap * law.inverse_range);
      return force;
    }
  }
  if constexpr (has(E, kHertz)) {
    // The library decides overlap exactly; here rounding may leave -0.0...1, which has no root.
    const Real overlap = std::max(meeting.overlap, Real(0));
    const Real contact_radius = std::sqrt(overlap / meeting.inverse_radius);  // a = sqrt(R d)
    force.stiffness = 2 * law.modulus * contact_radius;
    force.value = Real(2) / 3 * force.stiffness * overlap;
    // sqrt(mu K) d^0.25 = sqrt(mu S 2/3) with S = 3/2 K sqrt(d).
    if constexpr (has(E, kDissipation))
      force.damping = law.damping * std::sqrt(reduced_mass(meeting) * force.stiffness * (Real(2) / 3));
  } else {
    force.stiffness = law.stiffness;
    force.value = law.stiffness * meeting.overlap;
    if constexpr (has(E, kDissipation)) force.damping = law.damping * std::sqrt(reduced_mass(meeting));
  }
  // Over a whole contact the dashpot's impulse is 0, so friction that the spring alone bounds takes exactly its
  // coefficient times the normal impulse from a contact that slides throughout.
  force.spring = force.value;
  if constexpr (has(E, kDissipation)) force.value += force.damping * meeting.closing_speed;
  if constexpr (has(E, kAdhesion)) force.value -= law.adhesion_force;
  return force;
}

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

}  // namespace dem
