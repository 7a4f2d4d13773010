// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The power of everything that takes energy out of a simulation or puts it in.
//
// Velocity Verlet changes the kinetic energy in a step by exactly sum of F . (v_before + v_after) / 2 dt, and the mean
// of the two velocities is that at the time of the step. So with forces as the engine has them, from velocities that
// lag, and velocities at the time of the step the power of each channel times dt is what it did to the kinetic energy.
// Only springs, whose energy is known, then err by the square of dt.
#pragma once

#include "dem/engine/contact_loads.hpp"

#include <vector>

namespace dem {

// Per time; of friction and rolling what leaves the motion, the energy of their springs included. `lagging` has the
// velocities that the forces saw, `state` those at the time of the step.
template <int D>
Work power_of(const Setup &setup, const Snapshot &lagging, const Snapshot &state,
              const std::vector<ContactLoad<D>> &loads);

// Takes from friction and rolling what their springs hold now.
template <int D>
Work without_springs(Work work, const std::vector<ContactLoad<D>> &loads);

inline void add(Work &sum, const Work &power, double time) {
  for (double Work::*channel : {&Work::dashpot, &Work::friction, &Work::rolling, &Work::drag, &Work::input})
    sum.*channel += power.*channel * time;
}

}  // namespace dem
