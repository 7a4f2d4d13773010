// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Forces of the box's walls on the particles that reach them.
#pragma once

#include "dem/effects/contact_force.hpp"
#include "dem/state/bodies.hpp"
#include "dem/state/boundary.hpp"

#include <hgrid/hgrid.h>

#include <cstddef>

namespace dem {

// Contacts of particle `a` with wall `b`, ascending.
template <int D, class Real>
struct WallTask {
  Bodies<D, Real> *bodies;
  const Boundary<D, Real> *boundary;
  const ContactLaw<Real> *law;
  const hg_pair *contacts;
  Real step;                  // since the forces were last reckoned
  Vec<D, Real> *slip, *roll;  // memory of each contact (friction, rolling)
};

// Adds the forces of contacts first .. last - 1.
template <int D, class Real>
using WallKernel = void (*)(const WallTask<D, Real> &task, size_t first, size_t last);

// The kernel of a set of effects, of which those of the law count. Throws Error if this build has none.
template <int D, class Real>
WallKernel<D, Real> find_wall_kernel(EffectSet effects);

}  // namespace dem
