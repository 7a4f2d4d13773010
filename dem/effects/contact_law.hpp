// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The normal force of one contact and its energy, composed at compile time from the effects of the scene.
//
// Overlap d, closing speed v = -dd'/dt < 0 while the contact opens, reduced mass mu, reduced radius R.
//   linear         F = k d + c sqrt(mu k) v     c = -2 ln e / sqrt(pi^2 + ln^2 e): restitution e for every pair
//   modulus        the same with k = pi E R: each particle is a column of its own section pi r^2 and length r, of
//                  stiffness pi E r, and a contact two of them in series
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

enum class Partner { kParticle, kWall };

// What a scene says about contacts, as numbers that the kernels multiply with.
template <class Real>
struct ContactLaw {
  Real stiffness = 0, damping = 0;
  Real friction = 0, tangential_ratio = 0;  // mu, k_t / k
  Real rolling = 0, rolling_ratio = 0;      // the same of rolling
  Real adhesion_force = 0, range = 0, inverse_range = 0;
  Real modulus = 0;  // E* (Hertz), pi E (modulus)
};

// How far apart surfaces still act on each other.
inline double contact_range(const Physics &physics) {
  return has(physics.effects, kAdhesion) ? physics.contact.adhesion_range : 0;
}

// What of a contact the law asks for; the rest of NormalContact is not set.
constexpr EffectSet kNeedMass = kDissipation, kNeedRadius = kHertz | kModulus | kRolling,
                    kNeedVelocity = kDissipation | kFriction;

// What the normal force depends on.
template <class Real>
struct NormalContact {
  Real overlap, closing_speed;
  Real inverse_mass;    // 1/m_a + 1/m_b; 0 if neither can move
  Real inverse_radius;  // 1/r_a + 1/r_b
};

// Normal force and what the tangential force follows.
template <class Real>
struct NormalForce {
  Real value = 0;      // > 0 repels
  Real spring = 0;     // the spring's part: bounds the friction
  Real damping = 0;    // force per closing speed
  Real stiffness = 0;  // dF/dd
};

template <class Real>
Real reduced_mass(const NormalContact<Real> &contact) {
  return contact.inverse_mass > 0 ? 1 / contact.inverse_mass : Real(0);
}

template <EffectSet E, class Real>
NormalForce<Real> normal_force(const ContactLaw<Real> &law, const NormalContact<Real> &contact) {
  NormalForce<Real> force;
  if constexpr (has(E, kAdhesion)) {
    if (contact.overlap < 0) {
      force.value = -law.adhesion_force * std::max(Real(0), 1 + contact.overlap * law.inverse_range);
      return force;
    }
  }
  if constexpr (has(E, kHertz)) {
    // The library decides overlap exactly; here rounding may leave -0.0...1, which has no root.
    const Real overlap = std::max(contact.overlap, Real(0));
    const Real contact_radius = std::sqrt(overlap / contact.inverse_radius);  // a = sqrt(R d)
    force.stiffness = 2 * law.modulus * contact_radius;
    force.value = Real(2) / 3 * force.stiffness * overlap;
    // sqrt(mu K) d^0.25 = sqrt(mu S 2/3) with S = 3/2 K sqrt(d).
    if constexpr (has(E, kDissipation))
      force.damping = law.damping * std::sqrt(reduced_mass(contact) * force.stiffness * (Real(2) / 3));
  } else {
    force.stiffness = has(E, kModulus) ? law.modulus / contact.inverse_radius : law.stiffness;
    force.value = force.stiffness * contact.overlap;
    if constexpr (has(E, kDissipation)) {
      force.damping = law.damping * std::sqrt(reduced_mass(contact) * (has(E, kModulus) ? force.stiffness : Real(1)));
    }
  }
  // Over a whole contact the dashpot's impulse is 0, so friction that the spring alone bounds takes exactly its
  // coefficient times the normal impulse from a contact that slides throughout.
  force.spring = force.value;
  if constexpr (has(E, kDissipation)) force.value += force.damping * contact.closing_speed;
  if constexpr (has(E, kAdhesion)) force.value -= law.adhesion_force;
  return force;
}

// The energy that a contact without losses holds, 0 where its surfaces are out of range.
template <EffectSet E, class Real>
Real elastic_energy(const ContactLaw<Real> &law, const NormalContact<Real> &contact, const NormalForce<Real> &force) {
  if constexpr (has(E, kAdhesion)) {
    if (contact.overlap < 0) {
      const Real left = std::max(Real(0), law.range + contact.overlap);
      return -law.adhesion_force * left * law.inverse_range * left / 2;
    }
  }
  Real energy = (has(E, kHertz) ? Real(0.4) : Real(0.5)) * force.spring * contact.overlap;
  if constexpr (has(E, kAdhesion)) energy -= law.adhesion_force * (contact.overlap + law.range / 2);
  return energy;
}

// 1 / E* = sum of (1 - nu^2) / E, 1 / G* = sum of (2 - nu) / G, G = E / (2 (1 + nu)). A rigid wall adds nothing.
inline void set_moduli(const ContactParameters &p, Partner partner, double &normal, double &tangential) {
  const auto compliance = [](double young, double poisson) { return (1 - poisson * poisson) / young; };
  const auto shear_compliance = [](double young, double poisson) { return (2 - poisson) * 2 * (1 + poisson) / young; };
  double sum = compliance(p.young_modulus, p.poisson_ratio);
  double shear_sum = shear_compliance(p.young_modulus, p.poisson_ratio);
  if (partner == Partner::kParticle) {
    sum *= 2;
    shear_sum *= 2;
  } else if (p.wall_young_modulus > 0) {
    sum += compliance(p.wall_young_modulus, p.wall_poisson_ratio);
    shear_sum += shear_compliance(p.wall_young_modulus, p.wall_poisson_ratio);
  }
  normal = 1 / sum;
  tangential = 1 / shear_sum;
}

// Of the linear contact of two particles.
inline double linear_stiffness(const Physics &physics, double radius, double other) {
  const ContactParameters &p = physics.contact;
  return has(physics.effects, kModulus) ? kPi * p.modulus / (1 / radius + 1 / other) : p.stiffness;
}

template <class Real>
ContactLaw<Real> make_law(const Physics &physics, Partner partner) {
  const ContactParameters &p = physics.contact;
  ContactLaw<Real> law;
  const double log_e = has(physics.effects, kDissipation) ? std::log(p.restitution) : 0;
  const double loss = -log_e / std::sqrt(kPi * kPi + log_e * log_e);
  if (has(physics.effects, kHertz)) {
    double normal = 0, tangential = 0;
    set_moduli(p, partner, normal, tangential);
    law.modulus = static_cast<Real>(normal);
    law.damping = static_cast<Real>(std::sqrt(5.0) * loss);
    // k_t / k_n at any overlap: 8 G* a over 2 E* a.
    law.tangential_ratio = static_cast<Real>(4 * tangential / normal);
  } else if (has(physics.effects, kModulus)) {
    // Of a wall, the column under the particle: as wide and as long.
    const bool yields = partner == Partner::kWall && p.wall_modulus > 0;
    law.modulus = static_cast<Real>(kPi / (1 / p.modulus + (yields ? 1 / p.wall_modulus : 0)));
    law.damping = static_cast<Real>(2 * loss);
    law.tangential_ratio = static_cast<Real>(p.tangential_stiffness);
  } else {
    law.stiffness = static_cast<Real>(p.stiffness);
    law.damping = static_cast<Real>(2 * loss * std::sqrt(p.stiffness));
    law.tangential_ratio = static_cast<Real>(p.tangential_stiffness);
  }
  law.friction = static_cast<Real>(p.friction);
  law.rolling = static_cast<Real>(p.rolling_friction);
  law.rolling_ratio = static_cast<Real>(p.rolling_stiffness);
  if (has(physics.effects, kAdhesion)) {
    law.adhesion_force = static_cast<Real>(p.adhesion_force);
    law.range = static_cast<Real>(p.adhesion_range);
    law.inverse_range = static_cast<Real>(1 / p.adhesion_range);
  }
  return law;
}

}  // namespace dem
