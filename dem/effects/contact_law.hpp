// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The normal force of one contact and its energy, composed at compile time from the effects of the scene.
//
// Overlap d, closing speed v = -dd'/dt < 0 while the contact opens, reduced mass mu, reduced radius R.
//   linear         F = k d + c sqrt(mu k) v     c = -2 ln e / sqrt(pi^2 + ln^2 e): restitution e for every pair
//   modulus        the same with k = pi E R: each particle is a column of its own section pi r^2 and length r, of
//                  stiffness pi E r, and a contact two of them in series; of two materials
//                  k = pi / (1 / (E_a r_a) + 1 / (E_b r_b))
//   Hertz          F = K d^1.5 + a sqrt(mu K) d^0.25 v,  K = 4/3 E* sqrt(R),  a = -sqrt5 ln e / sqrt(pi^2 + ln^2 e):
//                  restitution e at every speed (Antypov & Elliott, EPL 94 (2011) 50004)
//   adhesion       F = k d - F_a for d >= 0, -F_a (1 + d / h) for -h < d < 0: reversible, pull-off force F_a, range h
// Near the end of a damped collision F is negative for a moment. It is left so: only then is the restitution e exactly.
#pragma once

#include "dem/base/vector.hpp"
#include "dem/effects/effects.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dem {

enum class Partner { kParticle, kWall };

// What a scene says about contacts, as numbers that the kernels multiply with.
template <class Real>
struct ContactLaw {
  Real stiffness = 0, damping = 0;
  Real friction = 0, tangential_ratio = 0;  // mu, k_t / k
  Real rolling = 0, rolling_ratio = 0;      // the same of rolling
  Real adhesion_force = 0, range = 0, inverse_range = 0;
  Real modulus = 0;        // E* (Hertz), pi E (modulus)
  Real share[2] = {1, 1};  // of 1 / r_a and 1 / r_b in what divides it (modulus, materials)
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
  Real inverse_length;  // the same weighted by the shares of the law (modulus, materials)
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
    force.stiffness = law.stiffness;
    if constexpr (has(E, kModulus))
      force.stiffness = law.modulus / (has(E, kMaterials) ? contact.inverse_length : contact.inverse_radius);
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

// The partner that a wall of no material is: of what `contact` says of walls, else rigid. A stiffness or modulus of 0
// is rigid.
inline ContactParameters plain_wall(const ContactParameters &p) {
  ContactParameters wall;
  wall.modulus = p.wall_modulus;
  wall.young_modulus = p.wall_young_modulus;
  wall.poisson_ratio = p.wall_poisson_ratio;
  return wall;
}

// 1 / E* = sum of (1 - nu^2) / E, 1 / G* = sum of (2 - nu) / G, G = E / (2 (1 + nu)). A rigid partner adds nothing.
inline void set_moduli(const ContactParameters &a, const ContactParameters &b, double &normal, double &tangential) {
  double sum = 0, shear_sum = 0;
  for (const ContactParameters *p : {&a, &b}) {
    if (p->young_modulus == 0) continue;
    const double poisson = p->poisson_ratio;
    sum += (1 - poisson * poisson) / p->young_modulus;
    shear_sum += (2 - poisson) * 2 * (1 + poisson) / p->young_modulus;
  }
  normal = 1 / sum;
  tangential = 1 / shear_sum;
}

// Of two springs: 1 / k the mean of 1 / k_a and 1 / k_b, k where both are k to the last bit; a rigid b adds nothing.
inline double paired_stiffness(double a, double b) { return b > 0 ? a * (2 * b / (a + b)) : a; }

// Of the linear contact of two particles of one material.
inline double linear_stiffness(EffectSet effects, const ContactParameters &p, double radius, double other) {
  return has(effects, kModulus) ? kPi * p.modulus / (1 / radius + 1 / other) : p.stiffness;
}

// The law of particles of material a with partners of b; `both`: the numbers that they share.
template <class Real>
ContactLaw<Real> make_law(EffectSet effects, const ContactParameters &a, const ContactParameters &b,
                          const ContactParameters &both, Partner partner) {
  ContactLaw<Real> law;
  const double log_e = has(effects, kDissipation) ? std::log(both.restitution) : 0;
  const double loss = -log_e / std::sqrt(kPi * kPi + log_e * log_e);
  law.damping = static_cast<Real>(2 * loss);
  law.tangential_ratio = static_cast<Real>(both.tangential_stiffness);
  if (has(effects, kHertz)) {
    double normal = 0, tangential = 0;
    set_moduli(a, b, normal, tangential);
    law.modulus = static_cast<Real>(normal);
    law.damping = static_cast<Real>(std::sqrt(5.0) * loss);
    // k_t / k_n at any overlap: 8 G* a over 2 E* a.
    law.tangential_ratio = static_cast<Real>(4 * tangential / normal);
  } else if (has(effects, kModulus) && partner == Partner::kWall) {
    // Of a wall, the column under the particle: as wide and as long.
    law.modulus = static_cast<Real>(kPi / (1 / a.modulus + (b.modulus > 0 ? 1 / b.modulus : 0)));
  } else if (has(effects, kModulus)) {
    // 1 / (E_a r_a) + 1 / (E_b r_b) = (share_a / r_a + share_b / r_b) / E.
    law.modulus = static_cast<Real>(kPi / (1 / paired_stiffness(a.modulus, b.modulus)));
    law.share[0] = static_cast<Real>(2 * b.modulus / (a.modulus + b.modulus));
    law.share[1] = static_cast<Real>(2 * a.modulus / (a.modulus + b.modulus));
  } else {
    const double stiffness = paired_stiffness(a.stiffness, b.stiffness);
    law.stiffness = static_cast<Real>(stiffness);
    law.damping = static_cast<Real>(2 * loss * std::sqrt(stiffness));
  }
  law.friction = static_cast<Real>(both.friction);
  law.rolling = static_cast<Real>(both.rolling_friction);
  law.rolling_ratio = static_cast<Real>(both.rolling_stiffness);
  if (has(effects, kAdhesion)) {
    law.adhesion_force = static_cast<Real>(both.adhesion_force);
    law.range = static_cast<Real>(both.adhesion_range);
    law.inverse_range = static_cast<Real>(1 / both.adhesion_range);
  }
  return law;
}

// All laws of a scene: one, or that of particles of material a with partners of b.
template <class Real>
class LawTable {
 public:
  LawTable(const Physics &physics, Partner partner) {
    const ContactParameters &all = physics.contact;
    const ContactParameters plain = partner == Partner::kWall ? plain_wall(all) : all;
    if (!has(physics.effects, kMaterials)) {
      laws_.push_back(make_law<Real>(physics.effects, all, plain, all, partner));
      return;
    }
    const std::vector<Material> &materials = physics.materials;
    width_ = materials.size() + 1;
    for (size_t a = 0; a < materials.size(); a++) {
      for (size_t b = 0; b < width_; b++) {
        const ContactParameters &other = b < materials.size() ? materials[b].contact : plain;
        laws_.push_back(make_law<Real>(physics.effects, materials[a].contact, other,
                                       physics.pairs[physics.pair_of(a, b)], partner));
      }
    }
  }

  // With one law for all: that one, whatever a and b.
  const ContactLaw<Real> &at(size_t a, size_t b) const { return laws_[width_ > 0 ? a * width_ + b : 0]; }
  const std::vector<ContactLaw<Real>> &all() const { return laws_; }
  size_t width() const { return width_; }

 private:
  std::vector<ContactLaw<Real>> laws_;
  size_t width_ = 0;
};

}  // namespace dem
