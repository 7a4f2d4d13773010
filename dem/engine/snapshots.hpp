// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Bodies from arrays in double, and the state of bodies in double, brought to the time of a step.
#pragma once

#include "dem/engine/engine.hpp"
#include "dem/kernels/motion_kernel.hpp"
#include "dem/state/bodies.hpp"

#include <cstddef>

namespace dem {

// Particles first 0 .. count - 1 with velocities advanced by `kick` under their forces, and positions taken back by
// `lead`; centres not yet brought into the box. Materials, time and image offset are the caller's.
template <int D, class Real>
Snapshot snapshot_of(const Bodies<D, Real> &bodies, size_t count, EffectSet effects,
                     const BodyForce<D, Real> &body_force, Real kick, Real lead);

// Body i becomes that particle of a setup, as it is at the step, whatever the scheme.
template <int D, class Real>
void set_body(const Setup &setup, size_t particle, Bodies<D, Real> &bodies, size_t i);

void bring_into_box(const Setup &setup, Snapshot &state);

}  // namespace dem
