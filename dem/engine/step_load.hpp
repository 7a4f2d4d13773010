// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How near a time step is to the limit of stability of all present contacts together (docs/theory/time-step.md).
#pragma once

#include "dem/engine/contact_loads.hpp"

#include <vector>

namespace dem {

// From 1 on the step may be unstable: dt^2 K + 2 dt C, the matrices of springs and dashpots, reaches 4 M (other
// schemes: as much as they bear). A bound that is exact for pairs of equal particles and close packings of them, and
// above the truth for others.
template <int D>
double step_load(const Setup &setup, const Snapshot &state, const std::vector<ContactLoad<D>> &contacts);

}  // namespace dem
