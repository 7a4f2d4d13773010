// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Friction and rolling of many contacts side by side: each waits for a root and quotients, which vectors take together.
#pragma once

#include "dem/effects/contact_force.hpp"
#include "dem/kernels/contact_batch.hpp"
#include "dem/state/bodies.hpp"

#include <hgrid/hgrid.h>

#include <cstddef>

namespace dem {

// Of each contact a slider, and the stretch of its spring before and after.
template <class Real, size_t kMost>
struct Sliders {
  Real stiffness[kMost], damping[kMost], limit[kMost];
  Row<Real> stretch[kMost];
  Real left[3][kMost];
};

// Rows as particles have them turn into columns of numbers. Few enough contacts that all stays in the first cache
// together with the particles.
template <class Real>
struct RoughBatch {
  static constexpr size_t kMost = 64;

  Row<Real> velocity[kMost];  // of the centres, a relative to b
  Row<Real> turning[kMost];   // arm times spin, of a and b together
  Row<Real> spin[kMost];      // of a relative to b (rolling)
  Real arm[2][kMost];         // from the centres to the middle of the overlap
  Real pressing[kMost];       // normal force
  Real radius[kMost];         // reduced (rolling)
  Sliders<Real, kMost> friction, rolling;
  Real force[3][kMost], moment[3][kMost], torque[3][kMost];  // on a; per arm; of rolling, on a
};

// Some of a batch of contacts.
template <int D, class Real>
struct RoughTask {
  Bodies<D, Real> *bodies;
  const hg_pair *pairs;
  size_t first_body, last_body;  // get forces
  History<D, Real> *history;
  Real step;
  const ContactBatch<Real> *contacts;
  size_t first, count;
};

// Before normal forces and sliders are known, and after.
template <int D, class Real>
struct RoughKernels {
  using Kernel = void (*)(const RoughTask<D, Real> &task, RoughBatch<Real> &batch);
  Kernel gather;  // how contacts move, and what they remember
  Kernel rub;     // what becomes of them: adds their forces and torques to their particles
};

// With the vectors that this machine has and HGRID_ISA allows: all give the same bits.
template <int D, class Real>
RoughKernels<D, Real> find_rough_kernels(EffectSet effects);

}  // namespace dem
