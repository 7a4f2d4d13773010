// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Integration schemes as lists of kicks (velocities advance) and drifts (positions advance).
#pragma once

#include <string>
#include <vector>

namespace dem {

// Forces are computed, then velocities advance by kick, then positions by drift; in time steps.
struct Stage {
  double kick, drift;
};

// A step is all stages in order. Where the last kick of a step and the first of the next use the same forces they are
// one: `shared_kick` is the part of the first kick that still belongs to the step before. Likewise `shared_drift` is
// the part of the last drift that belongs to the step after. So velocities run behind positions by shared_kick, or
// positions ahead by shared_drift, and what is shown is brought to the time of the step.
struct Scheme {
  std::string name;
  int order = 0;
  std::vector<Stage> stages;
  double shared_kick = 0, shared_drift = 0;
  double stability = 4;  // (w dt)^2 up to which a swing of frequency w stays bounded
};

// Kick 1/2, drift 1, kick 1/2.
Scheme velocity_verlet();
// Kick 1, drift 1.
Scheme symplectic_euler();
// Drift 1/2, kick 1, drift 1/2; also called position Verlet.
Scheme leapfrog();
// Three velocity Verlet steps of theta, 1 - 2 theta, theta with theta = 1 / (2 - 2^(1/3)) (Forest & Ruth, Physica D 43
// (1990) 105; Yoshida, Phys. Lett. A 150 (1990) 262). Steps go back in time in the middle: elastic contacts only.
Scheme forest_ruth();

// By name: velocity-verlet, symplectic-euler, leapfrog, forest-ruth. Throws Error for any other.
Scheme scheme_of_name(const std::string &name);

}  // namespace dem
