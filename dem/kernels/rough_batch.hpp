// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Friction and rolling of many contacts side by side: each waits for a root and quotients, which vectors take together.
#pragma once

#include "dem/state/bodies.hpp"

#include <cstddef>

namespace dem {

// Of each contact a slider and the stretch of its spring.
template <int D, class Real, size_t kMost>
struct SliderColumns {
  Real stiffness[kMost], damping[kMost], limit[kMost];
  Real stretch[D][kMost];
};

// Rows as particles have them; few enough that they stay in the first cache together with the particles.
template <int D, class Real>
struct RoughBatch {
  static constexpr size_t kMost = 128;

  Row<Real> velocity[kMost];  // of the centres, a relative to b; then the force on a
  Row<Real> turning[kMost];   // arm times spin, of a and b together; then the torque per arm
  Row<Real> spin[kMost];      // of a relative to b; then the torque on a (rolling)
  Real pressing[kMost];       // normal force
  Real radius[kMost];         // reduced (rolling)
  SliderColumns<D, Real, kMost> friction, rolling;
};

// What becomes of contacts 0 .. count - 1, whose unit vectors stand in `normal`.
template <int D, class Real>
using RoughKernel = void (*)(RoughBatch<D, Real> &batch, const Real *const (&normal)[3], size_t count, Real step);

// With the vectors that this machine has and HGRID_ISA allows: all give the same bits.
template <int D, class Real>
RoughKernel<D, Real> find_rough_kernel(EffectSet effects);

}  // namespace dem
