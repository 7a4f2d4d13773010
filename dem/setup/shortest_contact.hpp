// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The contacts that are over soonest, of any two particles or of one with a wall: what time steps are reckoned from.
#pragma once

#include "dem/setup/setup.hpp"

#include <vector>

namespace dem {

// Infinite frequencies and times mean that no particle can move.
struct ShortestContact {
  double duration = kInfinity;  // t_c of the damped contact
  double frequency = 0;         // w of its undamped swing: w^2 = k / mu, with Hertz at the deepest overlap
  double damping = 0;           // zeta = eta / w, the share of critical damping
  double crossing = kInfinity;  // time in which surfaces cross the range of adhesion
  double speed = 0;             // the approach that all this is for (Hertz, adhesion)
  double sinking = 0;           // and what adhesion adds from first touch to where the spring balances it
};

//   linear   w^2 = k / mu of the two lightest particles, t_c = pi / (w sqrt(1 - zeta^2))
//   modulus  w^2 = pi E r / m of the particle for which that is largest: no pair has more, a pair of two such has it
//   Hertz    w^2 = 15/8 (v / d)^2, t_c = 2.943275 d / v without dissipation, d = (15 mu v^2 / (16 E* sqrt(R)))^(2/5)
//   adhesion crossing = h / sqrt(v^2 + F_a h / mu)
// Of two materials the lightest and stiffest of either count; walls have contacts of their own if they have materials.
// v is the fastest approach: the impact speed if it is given, else (2 fastest at the start)^2 + 2 g x (the box along
// g). If the tangential spring is stiffer than the normal one, its swing counts. Throws Error if Hertz contacts come
// without any speed.
//
// Of each two materials, and of each material with a wall; at least one.
std::vector<ShortestContact> shortest_contacts(const Setup &setup);
// The shortest of them.
ShortestContact shortest_contact(const Setup &setup);

// How much more the springs of a crowd of contacts, each pointing anywhere, pull on a particle that slides or turns
// than on one that is pressed: 1, or more with friction.
double crowd_of_springs(const Setup &setup);

}  // namespace dem
