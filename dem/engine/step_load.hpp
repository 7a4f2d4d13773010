// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How near a time step is to the limit of stability of all present contacts together (docs/theory/time-step.md).
#pragma once

#include "dem/base/vector.hpp"
#include "dem/engine/engine.hpp"

#include <cstddef>
#include <vector>

namespace dem {

// A spring with its dashpot between particles a and b, or particle a and a wall.
template <int D>
struct LoadedContact {
  static constexpr size_t kWall = static_cast<size_t>(-1);

  size_t a, b;
  Vec<D, double> normal;  // from a to b
  double stiffness, damping;
  double tangential_ratio, rolling_ratio;  // of the springs along the surfaces
  double reduced_radius;
};

// From 1 on the step may be unstable: dt^2 K + 2 dt C, the matrices of springs and dashpots, reaches 4 M (other
// schemes: as much as they bear). A bound that is exact for pairs of equal particles and close packings of them, and
// above the truth for others.
template <int D>
double step_load(const Setup &setup, const Snapshot &state, const std::vector<LoadedContact<D>> &contacts);

}  // namespace dem
