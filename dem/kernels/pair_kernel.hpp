// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The loop over pairs of particles, one function for each set of effects; each dimension compiles in a file of its own.
#pragma once

#include "dem/effects/choice.hpp"
#include "dem/kernels/contact_kernel.hpp"

namespace dem {

// What a pair does to its two particles.
template <int D, class Real>
struct PairForce {
  Vec<D, Real> force;                // on a; b gets the opposite
  Spin<D, Real> torque_a, torque_b;  // friction only
};

template <EffectSet E, int D, class Real>
inline PairForce<D, Real> pair_force(const ContactTask<D, Real> &task, const ContactBatch<Real> &batch,
                                     History<D, Real> *history, size_t p, size_t a, size_t b) {
  const Bodies<D, Real> &bodies = *task.bodies;
  const ContactLaw<Real> &law = pair_law<E>(task, a, b);
  Contact<D, Real> contact;
  for (int axis = 0; axis < D; axis++) contact.normal[axis] = batch.normal[axis][p];
  contact.overlap = batch.touching[p] - batch.distance[p];
  if constexpr (has(E, kNeedMass)) contact.inverse_mass = bodies.inverse_mass(a) + bodies.inverse_mass(b);
  if constexpr (has(E, kNeedRadius)) contact.inverse_radius = 1 / bodies.radius(a) + 1 / bodies.radius(b);
  if constexpr (has(E, kModulus) && has(E, kMaterials))
    contact.inverse_length = law.share[0] / bodies.radius(a) + law.share[1] / bodies.radius(b);
  if constexpr (has(E, kNeedVelocity)) {
    contact.velocity = bodies.velocity(a) - bodies.velocity(b);
    if constexpr (has(E, kShear)) contact.velocity[0] -= batch.image_speed[p];
  }
  // From the centres to the middle of the overlap.
  [[maybe_unused]] const Real arm_a = bodies.radius(a) - contact.overlap / 2;
  [[maybe_unused]] const Real arm_b = bodies.radius(b) - contact.overlap / 2;
  if constexpr (has(E, kFriction)) contact.turning = arm_a * bodies.spin(a) + arm_b * bodies.spin(b);
  if constexpr (has(E, kRolling)) contact.spin = bodies.spin(a) - bodies.spin(b);
  const ContactForce<D, Real> on_a = contact_force<E>(law, contact, history, task.step, batch.place[p]);
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

// First particles of a list follow one another in memory; second ones do not, and are asked for in time.
constexpr size_t kContactsAhead = 12;

// Inlined whatever the compiler thinks: to gcc 12 a call that only fetches has no effect, and is left out.
template <EffectSet E, int D, class Real>
[[gnu::always_inline]] inline void fetch_ahead(const Bodies<D, Real> &bodies, const hg_pair *pairs,
                                               const ContactBatch<Real> &batch, size_t p) {
#ifdef __GNUC__
  const hg_pair &pair = pairs[batch.place[p + kContactsAhead < batch.count ? p + kContactsAhead : p]];
  const auto a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
  __builtin_prefetch(&bodies.moves[a], 1);
  __builtin_prefetch(&bodies.moves[b], 1);
  if constexpr (has(E, kFriction)) {
    __builtin_prefetch(&bodies.turns[a], 1);
    __builtin_prefetch(&bodies.turns[b], 1);
  }
#endif
}

template <EffectSet E, int D, class Real>
size_t pair_forces(const ContactTask<D, Real> &task, const PairRun<D, Real> &run) {
  Bodies<D, Real> &bodies = *task.bodies;
  const BatchTask<D, Real> source{bodies.places.data(), task.boundary, run.pairs, task.range};
  ContactBatch<Real> batch;
  size_t found = 0;
  if constexpr (has(E, effects_with_history())) run.history->begin_pass();
  for (size_t next = run.first_pair; next < run.last_pair;) {
    next = task.fill_batch(source, next, run.last_pair, batch);
    for (size_t p = 0; p < batch.count; p++) {
      fetch_ahead<E>(bodies, run.pairs, batch, p);
      const hg_pair &pair = run.pairs[batch.place[p]];
      const auto a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
      const PairForce<D, Real> result = pair_force<E>(task, batch, run.history, p, a, b);
      if (a >= run.first_body) {
        bodies.force(a) += result.force;
        if constexpr (has(E, kFriction)) bodies.torque(a) += result.torque_a;
      }
      if (b < run.last_body) {
        bodies.force(b) -= result.force;
        if constexpr (has(E, kFriction)) bodies.torque(b) += result.torque_b;
      }
    }
    found += batch.count;
  }
  return found;
}

template <int D, class Real>
ContactKernel<D, Real> find_pair_kernel(EffectSet effects) {
  return choose<kPairEffects, Real>(effects, [](auto set) { return &pair_forces<decltype(set)::value, D, Real>; });
}

}  // namespace dem
