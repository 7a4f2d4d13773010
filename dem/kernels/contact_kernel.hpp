// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The forces of a list of pairs that may touch, of particles or of particles with walls: what they are computed from.
#pragma once

#include "dem/effects/contact_force.hpp"
#include "dem/kernels/contact_batch.hpp"
#include "dem/kernels/rough_batch.hpp"
#include "dem/state/bodies.hpp"
#include "dem/state/boundary.hpp"

#include <hgrid/hgrid.h>

#include <cstddef>

namespace dem {

template <int D, class Real>
struct ContactTask {
  Bodies<D, Real> *bodies;
  const Boundary<D, Real> *boundary;
  const ContactLaw<Real> *laws;  // one for all; of materials a and b: [a * law_row + b]
  size_t law_row;
  Real step;                                    // the time since the forces were last computed
  Real range;                                   // how far surfaces act beyond touching
  BatchFiller<D, Real> fill_batch = nullptr;    // of two particles
  RoughKernel<D, Real> rough_kernel = nullptr;  // of those with friction
};

// The law of particle i with another, or with a wall whose materials the boundary knows.
template <EffectSet E, int D, class Real>
const ContactLaw<Real> &pair_law(const ContactTask<D, Real> &task, [[maybe_unused]] size_t i,
                                 [[maybe_unused]] size_t other) {
  if constexpr (has(E, kMaterials))
    return task.laws[task.bodies->materials[i] * task.law_row + task.bodies->materials[other]];
  return *task.laws;
}
template <EffectSet E, int D, class Real>
const ContactLaw<Real> &wall_law(const ContactTask<D, Real> &task, [[maybe_unused]] size_t i,
                                 [[maybe_unused]] int32_t wall) {
  if constexpr (has(E, kMaterials))
    return task.laws[task.bodies->materials[i] * task.law_row + task.boundary->materials[wall]];
  return *task.laws;
}

// Pairs of a list, what the contacts among them remember, and the particles that get forces.
template <int D, class Real>
struct PairRun {
  const hg_pair *pairs;  // of two particles, or of particle a with wall b; ascending
  size_t first_pair, last_pair;
  size_t first_body, last_body;
  History<D, Real> *history;
};

// Adds the forces of the contacts among those pairs; returns how many they are.
template <int D, class Real>
using ContactKernel = size_t (*)(const ContactTask<D, Real> &task, const PairRun<D, Real> &run);

// The kernels of a set of effects, of which those of pairs or contacts count. Throw Error if this build has none.
template <int D, class Real>
ContactKernel<D, Real> find_pair_kernel(EffectSet effects);
template <int D, class Real>
ContactKernel<D, Real> find_wall_kernel(EffectSet effects);

}  // namespace dem
