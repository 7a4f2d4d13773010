// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Collisions of two spheres that begin at any moment within a time step, against closed forms: the damped oscillator,
// and Hertz contacts.
#pragma once

#include "dem/engine/engine.hpp"

#include <cstddef>
#include <cstdint>

namespace accuracy {

// Many pairs collide head-on, each far from all others.
struct CollisionCase {
  dem::Scheme scheme = dem::velocity_verlet();
  double steps = 50;       // n: time steps per contact
  double restitution = 1;  // below 1: with a dashpot
  bool hertz = false;      // then duration and overlap have a closed form without a dashpot only
  // Whether a contact lasts n steps exactly, as of equal spheres. Else pairs differ in mass, so that contacts last any
  // number of steps from n to n + 1, as of spheres of many sizes.
  bool whole_steps = true;
  size_t pairs = 400;
  uint64_t seed = 1;
  dem::Precision precision = dem::Precision::kDouble;
};

// Over all pairs.
struct Deviation {
  double mean = 0, rms = 0;
};

struct CollisionErrors {
  double steps = 0;       // per contact, on average
  Deviation duration;     // relative; from the free paths before and after: when the surfaces met and parted
  Deviation restitution;  // e found - e
  Deviation overlap;      // relative; the largest at the time of any step
};

// Throws dem::Error if the setup is refused or a pair has not parted in time.
CollisionErrors collide(const CollisionCase &what);

}  // namespace accuracy
