// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The loop over pairs of particles, one function for each set of effects; each dimension compiles in a file of its own.
#pragma once

#include "dem/effects/choice.hpp"
#include "dem/kernels/contact_kernel.hpp"
#include "dem/kernels/pair_contact.hpp"
#include "dem/kernels/rough_kernel.hpp"

#include <type_traits>

namespace dem {

// Of contacts without friction one after the other: what there is to compute fits between the loads.
template <EffectSet E, int D, class Real>
struct SmoothContacts {
  const ContactTask<D, Real> &task;
  const PairRun<D, Real> &run;

  void add_forces(const ContactBatch<Real> &batch) const {
    Bodies<D, Real> &bodies = *task.bodies;
    for (size_t p = 0; p < batch.count; p++) {
      fetch_ahead(bodies, run.pairs, batch, p);
      const hg_pair &pair = run.pairs[batch.place[p]];
      const auto a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
      const ContactLaw<Real> &law = pair_law<E>(task, a, b);
      NormalContact<Real> contact = normal_contact<E>(bodies, law, batch, p, a, b);
      Vec<D, Real> normal;
      for (int axis = 0; axis < D; axis++) normal[axis] = batch.normal[axis][p];
      if constexpr (has(E, kDissipation))
        contact.closing_speed = relative_velocity<E>(bodies, batch, p, a, b).dot(normal);
      const Vec<D, Real> force = -normal_force<E, Real>(law, contact).value * normal;
      if (a >= run.first_body) bodies.force(a) += force;
      if (b < run.last_body) bodies.force(b) -= force;
    }
  }
};

template <EffectSet E, int D, class Real>
size_t pair_forces(const ContactTask<D, Real> &task, const PairRun<D, Real> &run) {
  const BatchTask<D, Real> source{task.bodies->places.data(), task.boundary, run.pairs, task.range};
  std::conditional_t<has(E, kFriction), RoughContacts<E, D, Real>, SmoothContacts<E, D, Real>> contacts{task, run};
  ContactBatch<Real> batch;
  size_t found = 0;
  if constexpr (has(E, effects_with_history())) run.history->begin_pass();
  for (size_t next = run.first_pair; next < run.last_pair; found += batch.count) {
    next = task.fill_batch(source, next, run.last_pair, batch);
    contacts.add_forces(batch);
  }
  return found;
}

template <int D, class Real>
ContactKernel<D, Real> find_pair_kernel(EffectSet effects) {
  return choose<kPairEffects, Real>(effects, [](auto set) { return &pair_forces<decltype(set)::value, D, Real>; });
}

}  // namespace dem
