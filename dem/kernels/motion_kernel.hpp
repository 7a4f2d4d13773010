// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The one pass over the particles in each step: velocities, positions, forces back to zero, who reaches a wall.
#pragma once

#include "dem/effects/body_force.hpp"
#include "dem/state/bodies.hpp"
#include "dem/state/boundary.hpp"

#include <hgrid/hgrid.h>

#include <cstddef>
#include <vector>

namespace dem {

template <int D, class Real>
struct MotionTask {
  Bodies<D, Real> *bodies;
  const Boundary<D, Real> *boundary;
  BodyForce<D, Real> body_force;
  Real kick, drift;  // times by which velocities and positions advance
  Real wall_range;   // walls act on surfaces nearer than this
};

// v += kick a, x += drift v for particles first .. last - 1. Appends the walls that they then reach, as pairs of
// particle and wall in ascending order.
template <int D, class Real>
using MotionKernel = void (*)(const MotionTask<D, Real> &task, size_t first, size_t last,
                              std::vector<hg_pair> &wall_contacts);

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
