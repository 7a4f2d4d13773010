// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The loop over pairs of particles, one function for each set of effects.
#pragma once

#include "dem/effects/contact_force.hpp"
#include "dem/state/bodies.hpp"
#include "dem/state/boundary.hpp"

#include <hgrid/hgrid.h>

#include <cmath>
#include <cstddef>

namespace dem {

// What a pair does to its two particles, kept until one thread after the other adds it up.
template <int D, class Real>
struct PairEffort {
  Vec<D, Real> force;                // on a; b gets the opposite
  Spin<D, Real> torque_a, torque_b;  // friction only
};

// A pair list and what its forces are reckoned from.
template <int D, class Real>
struct PairTask {
  Bodies<D, Real> *bodies;
  const Boundary<D, Real> *boundary;
  const ContactLaw<Real> *law;
  const hg_pair *pairs;
  Real step;                     // since the forces were last reckoned
  Vec<D, Real> *slip, *roll;     // memory of each pair (friction, rolling)
  PairEffort<D, Real> *efforts;  // of each pair, to be added up later; null: add at once
};

// Reckons the pairs first .. last - 1.
template <int D, class Real>
using PairKernel = void (*)(const PairTask<D, Real> &task, size_t first, size_t last);

// The kernel of a set of effects, of which those of the pair count. Throws Error if this build has none.
template <int D, class Real>
PairKernel<D, Real> find_pair_kernel(EffectSet effects);

// Unit vector and length of a separation. Centres that coincide are pushed apart along x, the first to the left.
template <int D, class Real>
Real split_direction(const Vec<D, Real> &separation, Vec<D, Real> &direction) {
  const Real distance = std::sqrt(separation.squaredNorm());
  if (distance > 0) {
    direction = separation * (1 / distance);
  } else {
    direction = Vec<D, Real>::UnitX();
  }
  return distance;
}

template <EffectSet E, int D, class Real>
Contact<D, Real> meet(const PairTask<D, Real> &task, const hg_pair &pair) {
  const Bodies<D, Real> &bodies = *task.bodies;
  const auto a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
  Contact<D, Real> contact;
  Vec<D, Real> separation = bodies.position[b] - bodies.position[a];
  [[maybe_unused]] const Real image_speed = task.boundary->template nearest<E>(separation);
  const Real distance = split_direction<D>(separation, contact.normal);
  contact.meeting.overlap = bodies.radius[a] + bodies.radius[b] - distance;
  if constexpr (has(E, kDissipation)) contact.meeting.inverse_mass = bodies.inverse_mass[a] + bodies.inverse_mass[b];
  if constexpr (has(E, kHertz) || has(E, kRolling))
    contact.meeting.inverse_radius = 1 / bodies.radius[a] + 1 / bodies.radius[b];
  if constexpr (has(E, kDissipation) || has(E, kFriction)) {
    contact.velocity = bodies.velocity[a] - bodies.velocity[b];
    if constexpr (has(E, kShear)) contact.velocity[0] -= image_speed;
  }
  return contact;
}

// From the centre of particle i to the middle of the overlap.
template <int D, class Real>
Real arm(const Bodies<D, Real> &bodies, int32_t i, Real overlap) {
  return bodies.radius[static_cast<size_t>(i)] - overlap / 2;
}

template <EffectSet E, int D, class Real>
void add_effort(Bodies<D, Real> &bodies, const hg_pair &pair, const PairEffort<D, Real> &effort) {
  const auto a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
  bodies.force[a] += effort.force;
  bodies.force[b] -= effort.force;
  if constexpr (has(E, kFriction)) {
    bodies.torque[a] += effort.torque_a;
    bodies.torque[b] += effort.torque_b;
  }
}

// Adds up the efforts of a whole list, ascending in a, on particles first .. last - 1.
template <int D, class Real>
void add_efforts(Bodies<D, Real> &bodies, const hg_pair *pairs, size_t count, const PairEffort<D, Real> *efforts,
                 size_t first, size_t last) {
  const bool rotating = !bodies.torque.empty();
  for (size_t p = 0; p < count; p++) {
    const auto a = static_cast<size_t>(pairs[p].a), b = static_cast<size_t>(pairs[p].b);
    if (a >= last) return;
    if (a >= first) {
      bodies.force[a] += efforts[p].force;
      if (rotating) bodies.torque[a] += efforts[p].torque_a;
    }
    if (b >= first && b < last) {
      bodies.force[b] -= efforts[p].force;
      if (rotating) bodies.torque[b] += efforts[p].torque_b;
    }
  }
}

template <EffectSet E, int D, class Real>
PairEffort<D, Real> pair_effort(const PairTask<D, Real> &task, size_t p) {
  const Bodies<D, Real> &bodies = *task.bodies;
  const hg_pair pair = task.pairs[p];
  Contact<D, Real> contact = meet<E>(task, pair);
  PairEffort<D, Real> result;
  if constexpr (has(E, kFriction)) {
    const auto a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
    const Real arm_a = arm(bodies, pair.a, contact.meeting.overlap);
    const Real arm_b = arm(bodies, pair.b, contact.meeting.overlap);
    const Spin<D, Real> turning = arm_a * bodies.spin[a] + arm_b * bodies.spin[b];
    contact.surface_velocity = contact.velocity + turn<D, Real>(turning, contact.normal);
    contact.step = task.step;
    contact.slip = task.slip + p;
    if constexpr (has(E, kRolling)) {
      contact.spin = bodies.spin[a] - bodies.spin[b];
      contact.roll = task.roll + p;
    }
    const Effort<D, Real> effort = contact_effort<E>(*task.law, contact);
    result.force = effort.force;
    result.torque_a = arm_a * effort.moment;
    result.torque_b = arm_b * effort.moment;
    if constexpr (has(E, kRolling)) {
      result.torque_a += effort.rolling;
      result.torque_b -= effort.rolling;
    }
  } else {
    result.force = contact_effort<E>(*task.law, contact).force;
  }
  return result;
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
void pair_forces(const PairTask<D, Real> &task, size_t first, size_t last) {
  if (task.efforts != nullptr) {
    for (size_t p = first; p < last; p++) task.efforts[p] = pair_effort<E>(task, p);
  } else {
    for (size_t p = first; p < last; p++) {
      fetch_ahead(*task.bodies, task.pairs[p + kPairsAhead < last ? p + kPairsAhead : p]);
      add_effort<E>(*task.bodies, task.pairs[p], pair_effort<E>(task, p));
    }
  }
}

}  // namespace dem
