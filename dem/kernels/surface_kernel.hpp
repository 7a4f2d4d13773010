// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Forces of walls beside those of the box on the particles that reach them.
#pragma once

#include "dem/effects/contact_force.hpp"
#include "dem/state/bodies.hpp"
#include "dem/state/surfaces.hpp"

namespace dem {

template <int D>
struct SurfaceTask {
  Bodies<D, double> *bodies;
  Surfaces<D> *surfaces;
  const ContactLaw<double> *laws;  // one for all; of materials a and b: [a * law_row + b]
  size_t law_row;
  double step;   // the time since the forces were last computed
  double range;  // how far surfaces act beyond touching
};

// Adds the forces at places first .. last - 1 of the list, which hold all surfaces of their particles.
template <int D>
using SurfaceKernel = void (*)(const SurfaceTask<D> &task, size_t first, size_t last, History<D, double> *history);

// The kernel of a set of effects, of which those of contacts count. Throws Error if this build has none.
template <int D>
SurfaceKernel<D> find_surface_kernel(EffectSet effects);

}  // namespace dem
