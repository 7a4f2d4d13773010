// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Forces on single particles from outside, and their potential energy.
#pragma once

#include "dem/base/vector.hpp"
#include "dem/effects/effects.hpp"

namespace dem {

template <int D, class Real>
struct BodyForce {
  Vec<D, Real> gravity;  // acceleration
  Real drag;             // 6 pi eta: force per radius and speed
};

inline double drag_of(const Physics &physics) { return 6 * kPi * physics.viscosity; }

template <int D, class Real>
BodyForce<D, Real> make_body_force(const Physics &physics) {
  return {Eigen::Map<const Vec<D, double>>(physics.gravity).template cast<Real>(), static_cast<Real>(drag_of(physics))};
}

// The acceleration of a particle that contacts push with `force`; fixed ones have inverse mass 0.
template <EffectSet E, int D, class Real>
inline Vec<D, Real> acceleration(const BodyForce<D, Real> &from_outside, const Vec<D, Real> &force,
                                 const Vec<D, Real> &velocity, Real radius, Real inverse_mass) {
  Vec<D, Real> result = force * inverse_mass;
  if constexpr (has(E, kGravity)) {
    if (inverse_mass > 0) result += from_outside.gravity;
  }
  if constexpr (has(E, kDrag)) result -= (from_outside.drag * radius * inverse_mass) * velocity;
  return result;
}

// 0 at the origin.
template <EffectSet E, int D>
double potential_energy([[maybe_unused]] const BodyForce<D, double> &from_outside, const Vec<D, double> &position,
                        double mass) {
  double energy = 0;
  if constexpr (has(E, kGravity)) energy -= mass * from_outside.gravity.dot(position);
  return energy;
}

}  // namespace dem
