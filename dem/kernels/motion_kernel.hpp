// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The one pass over the particles in each step: velocities, positions, forces back to zero.
#pragma once

#include "dem/effects/body_force.hpp"
#include "dem/state/bodies.hpp"

#include <cstddef>

namespace dem {

template <int D, class Real>
struct MotionTask {
  Bodies<D, Real> *bodies;
  BodyForce<D, Real> body_force;
  Real kick, drift;  // times by which velocities and positions advance
};

// v += kick a, x += drift v for particles first .. last - 1. Returns the largest v^2, or no number if one is infinite
// or none.
template <int D, class Real>
using MotionKernel = Real (*)(const MotionTask<D, Real> &task, size_t first, size_t last);

// The acceleration of a particle under the forces of the present positions.
template <int D, class Real>
using AccelerationKernel = Vec<D, Real> (*)(const Bodies<D, Real> &bodies, const BodyForce<D, Real> &body_force,
                                            size_t particle);

// The kernels of a set of effects, of which those of motion or on bodies count. Throw Error if this build has none.
template <int D, class Real>
MotionKernel<D, Real> find_motion_kernel(EffectSet effects);
template <int D, class Real>
AccelerationKernel<D, Real> find_acceleration(EffectSet effects);

}  // namespace dem
