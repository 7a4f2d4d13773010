// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// From the material's numbers to those the kernels multiply with.
#include "dem/effects/contact_law.hpp"

#include "dem/base/error.hpp"

namespace dem {
namespace {

constexpr double kPi = 3.14159265358979323846;

void require(bool fulfilled, const char *what, double value) {
  if (!fulfilled) throw Error(std::string(what) + ", not " + text(value));
}

void check_parameters(const ContactParameters &p, EffectSet effects) {
  const bool hertz = has(effects, kHertz);
  if (!hertz) require(p.stiffness > 0 && std::isfinite(p.stiffness), "the stiffness is above 0", p.stiffness);
  if (hertz) {
    require(p.young_modulus > 0, "Young's modulus is above 0", p.young_modulus);
    require(p.poisson_ratio > -1 && p.poisson_ratio <= 0.5, "Poisson's ratio lies in (-1, 0.5]", p.poisson_ratio);
    require(p.wall_young_modulus >= 0, "the walls' modulus is 0 (rigid) or above", p.wall_young_modulus);
  }
  if (has(effects, kDissipation)) {
    require(p.restitution > 0 && p.restitution <= 1, "the restitution lies in (0, 1]", p.restitution);
  }
  if (has(effects, kFriction)) {
    require(p.friction >= 0, "the coefficient of friction is 0 or above", p.friction);
    if (!hertz) require(p.tangential_stiffness > 0, "the tangential stiffness is above 0", p.tangential_stiffness);
  }
  if (has(effects, kRolling)) {
    require(p.rolling_friction >= 0, "the coefficient of rolling friction is 0 or above", p.rolling_friction);
    require(p.rolling_stiffness > 0, "the rolling stiffness is above 0", p.rolling_stiffness);
  }
  if (has(effects, kAdhesion)) {
    require(p.adhesion_force >= 0, "the pull-off force is 0 or above", p.adhesion_force);
    require(p.adhesion_range > 0, "the range of adhesion is above 0", p.adhesion_range);
  }
}

// 1 / E* = sum of (1 - nu^2) / E, 1 / G* = sum of (2 - nu) / G, G = E / (2 (1 + nu)). A rigid wall adds nothing.
void set_moduli(const ContactParameters &p, Partner partner, double &normal, double &tangential) {
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

}  // namespace

template <class Real>
ContactLaw<Real> make_law(const ContactParameters &p, EffectSet effects, Partner partner) {
  check_parameters(p, effects);
  ContactLaw<Real> law;
  const double log_e = has(effects, kDissipation) ? std::log(p.restitution) : 0;
  const double loss = -log_e / std::sqrt(kPi * kPi + log_e * log_e);
  if (has(effects, kHertz)) {
    double normal = 0, tangential = 0;
    set_moduli(p, partner, normal, tangential);
    law.modulus = static_cast<Real>(normal);
    law.damping = static_cast<Real>(std::sqrt(5.0) * loss);
    // k_t / k_n at any overlap: 8 G* a over 2 E* a.
    law.tangential_ratio = static_cast<Real>(4 * tangential / normal);
  } else {
    law.stiffness = static_cast<Real>(p.stiffness);
    law.damping = static_cast<Real>(2 * loss * std::sqrt(p.stiffness));
    law.tangential_ratio = static_cast<Real>(p.tangential_stiffness);
  }
  law.friction = static_cast<Real>(p.friction);
  law.rolling = static_cast<Real>(p.rolling_friction);
  law.rolling_ratio = static_cast<Real>(p.rolling_stiffness);
  if (has(effects, kAdhesion)) {
    law.adhesion_force = static_cast<Real>(p.adhesion_force);
    law.inverse_range = static_cast<Real>(1 / p.adhesion_range);
  }
  return law;
}

template ContactLaw<double> make_law(const ContactParameters &, EffectSet, Partner);
template ContactLaw<float> make_law(const ContactParameters &, EffectSet, Partner);

}  // namespace dem
