// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The forces of a list of contacts, of pairs of particles or of particles with walls: what they are computed from.
#pragma once

#include "dem/effects/contact_force.hpp"
#include "dem/state/bodies.hpp"
#include "dem/state/boundary.hpp"

#include <hgrid/hgrid.h>

#include <cstddef>

namespace dem {

// What a pair does to its two particles, kept until one thread after the other adds it up.
template <int D, class Real>
struct PairForce {
  Vec<D, Real> force;                // on a; b gets the opposite
  Spin<D, Real> torque_a, torque_b;  // friction only
};

template <int D, class Real>
struct ContactTask {
  Bodies<D, Real> *bodies;
  const Boundary<D, Real> *boundary;
  const ContactLaw<Real> *law;
  const hg_pair *contacts;              // of two particles, or of particle a with wall b; ascending
  History<D, Real> history;             // its step: the time since the forces were last computed
  PairForce<D, Real> *pairs = nullptr;  // where the forces of each pair go, to be added up later; null: add at once
};

// Computes the forces of contacts first .. last - 1.
template <int D, class Real>
using ContactKernel = void (*)(const ContactTask<D, Real> &task, size_t first, size_t last);

// The kernels of a set of effects, of which those of pairs or contacts count. Throw Error if this build has none.
template <int D, class Real>
ContactKernel<D, Real> find_pair_kernel(EffectSet effects);
template <int D, class Real>
ContactKernel<D, Real> find_wall_kernel(EffectSet effects);

// Adds up the forces of a whole list of pairs on particles first .. last - 1.
template <int D, class Real>
void add_pair_forces(Bodies<D, Real> &bodies, const hg_pair *pairs, size_t count, const PairForce<D, Real> *forces,
                     size_t first, size_t last) {
  const bool rotating = !bodies.torque.empty();
  for (size_t p = 0; p < count; p++) {
    const auto a = static_cast<size_t>(pairs[p].a), b = static_cast<size_t>(pairs[p].b);
    if (a >= last) return;
    if (a >= first) {
      bodies.force[a] += forces[p].force;
      if (rotating) bodies.torque[a] += forces[p].torque_a;
    }
    if (b >= first && b < last) {
      bodies.force[b] -= forces[p].force;
      if (rotating) bodies.torque[b] += forces[p].torque_b;
    }
  }
}

}  // namespace dem
