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
  Real step;                                  // the time since the forces were last computed
  Real range;                                 // how far surfaces act beyond touching
  BatchFiller<D, Real> fill_batch = nullptr;  // of two particles
  RoughKernels<D, Real> rough_kernels{};      // of those with friction
};

// The law of particle i with a partner; material_of_partner() is asked only where there are several materials.
template <EffectSet E, class Task, class Material>
const auto &law_with(const Task &task, [[maybe_unused]] size_t i, [[maybe_unused]] Material material_of_partner) {
  if constexpr (has(E, kMaterials))
    return task.laws[task.bodies->materials[i] * task.law_row + material_of_partner()];
  else
    return *task.laws;
}
template <EffectSet E, class Task>
const auto &pair_law(const Task &task, size_t i, size_t other) {
  return law_with<E>(task, i, [&] { return task.bodies->materials[other]; });
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
