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

namespace dem {

// Of contacts that are added and of particles. `lagging` has the velocities that the forces saw, `state` those at the
// time of the step; it refers to both.
template <int D>
class PowerMeasure {
 public:
  PowerMeasure(const Setup &setup, const Snapshot &lagging, const Snapshot &state);
  void add(const ContactLoad<D> &load);

  // Per time; of friction and rolling what leaves the motion, the energy of their springs included.
  Work power() const;

  // What the springs of friction and rolling hold.
  const Work &held() const { return held_; }

 private:
  double push_of_fixed(const ContactLoad<D> &load) const;

  const Setup &setup_;
  const Snapshot &lagging_, &state_;
  Work contacts_, held_;
};

inline void add(Work &sum, const Work &power, double time) {
  for (double Work::*channel : {&Work::dashpot, &Work::friction, &Work::rolling, &Work::drag, &Work::input})
    sum.*channel += power.*channel * time;
}

}  // namespace dem
