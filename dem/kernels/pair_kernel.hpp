// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The loop over pairs of particles, one function for each set of effects; each dimension compiles in a file of its own.
#pragma once

#include "dem/effects/choice.hpp"
#include "dem/kernels/contact_kernel.hpp"

namespace dem {

template <EffectSet E, int D, class Real>
PairForce<D, Real> pair_force(const ContactTask<D, Real> &task, size_t p) {
  const Bodies<D, Real> &bodies = *task.bodies;
  const auto a = static_cast<size_t>(task.contacts[p].a), b = static_cast<size_t>(task.contacts[p].b);
  Contact<D, Real> contact;
  Vec<D, Real> separation = bodies.position[b] - bodies.position[a];
  [[maybe_unused]] const Real image_speed = task.boundary->template nearest<E>(separation);
  const Real distance = normalize<D>(separation, contact.normal);
  contact.overlap = bodies.radius[a] + bodies.radius[b] - distance;
  if constexpr (has(E, kNeedMass)) contact.inverse_mass = bodies.inverse_mass[a] + bodies.inverse_mass[b];
  if constexpr (has(E, kNeedRadius)) contact.inverse_radius = 1 / bodies.radius[a] + 1 / bodies.radius[b];
  if constexpr (has(E, kNeedVelocity)) {
    contact.velocity = bodies.velocity[a] - bodies.velocity[b];
    if constexpr (has(E, kShear)) contact.velocity[0] -= image_speed;
  }
  // From the centres to the middle of the overlap.
  [[maybe_unused]] const Real arm_a = bodies.radius[a] - contact.overlap / 2;
  [[maybe_unused]] const Real arm_b = bodies.radius[b] - contact.overlap / 2;
  if constexpr (has(E, kFriction)) contact.turning = arm_a * bodies.spin[a] + arm_b * bodies.spin[b];
  if constexpr (has(E, kRolling)) contact.spin = bodies.spin[a] - bodies.spin[b];
  const ContactForce<D, Real> on_a = contact_force<E>(*task.law, contact, task.history, p);
  PairForce<D, Real> result;
  result.force = on_a.force;
  if constexpr (has(E, kFriction)) {
    result.torque_a = arm_a * on_a.moment;
    result.torque_b = arm_b * on_a.moment;
  }
  if constexpr (has(E, kRolling)) {
    result.torque_a += on_a.rolling;
    result.torque_b -= on_a.rolling;
  }
  return result;
}

template <EffectSet E, int D, class Real>
void add_pair_force(Bodies<D, Real> &bodies, const hg_pair &pair, const PairForce<D, Real> &pair_force) {
  const auto a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
  bodies.force[a] += pair_force.force;
  bodies.force[b] -= pair_force.force;
  if constexpr (has(E, kFriction)) {
    bodies.torque[a] += pair_force.torque_a;
    bodies.torque[b] += pair_force.torque_b;
  }
}

// First particles of a list follow one another in memory; second ones do not, and are asked for in time.
constexpr size_t kPairsAhead = 16;

template <int D, class Real>
void fetch_ahead(const Bodies<D, Real> &bodies, const hg_pair &pair) {
#ifdef __GNUC__
  const auto b = static_cast<size_t>(pair.b);
  __builtin_prefetch(&bodies.position[b]);
  __builtin_prefetch(&bodies.force[b], 1);
#endif
}

template <EffectSet E, int D, class Real>
void pair_forces(const ContactTask<D, Real> &task, size_t first, size_t last) {
  if (task.pairs != nullptr) {
    for (size_t p = first; p < last; p++) task.pairs[p] = pair_force<E>(task, p);
  } else {
    for (size_t p = first; p < last; p++) {
      fetch_ahead(*task.bodies, task.contacts[p + kPairsAhead < last ? p + kPairsAhead : p]);
      add_pair_force<E>(*task.bodies, task.contacts[p], pair_force<E>(task, p));
    }
  }
}

template <int D, class Real>
ContactKernel<D, Real> find_pair_kernel(EffectSet effects) {
  return choose<kPairEffects, Real>(effects, [](auto set) { return &pair_forces<decltype(set)::value, D, Real>; });
}

}  // namespace dem
