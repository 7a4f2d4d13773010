// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The one pass over the particles in each step: velocities, positions, forces back to zero, who reaches a wall.
#pragma once

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
  Real kick, drift;      // times by which velocities and positions advance
  Vec<D, Real> gravity;  // acceleration
  Real drag;             // 6 pi eta: force per radius and speed
  Real wall_range;       // walls act on surfaces nearer than this
};

// v += kick a, x += drift v for particles first .. last - 1. Appends the walls that they then reach, as pairs of
// particle and wall in ascending order.
template <int D, class Real>
using MotionKernel = void (*)(const MotionTask<D, Real> &task, size_t first, size_t last,
                              std::vector<hg_pair> &wall_contacts);

// The kernel of a set of effects, of which those of motion count. Throws Error if this build has none.
template <int D, class Real>
MotionKernel<D, Real> find_motion_kernel(EffectSet effects);

// a of particle i under its force, without its drag.
template <EffectSet E, int D, class Real>
Vec<D, Real> acceleration(const Bodies<D, Real> &bodies, const Vec<D, Real> &gravity, size_t i) {
  Vec<D, Real> result = bodies.force[i] * bodies.inverse_mass[i];
  if constexpr (has(E, kGravity)) {
    if (bodies.inverse_mass[i] > 0) result += gravity;
  }
  return result;
}

}  // namespace dem
