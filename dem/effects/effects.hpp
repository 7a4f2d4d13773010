// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The effects a scene can ask for, as a set that is known when a kernel is compiled.
//
// An effect that is not in the set costs nothing: the kernels test the set with `if constexpr`, and arrays that only
// this effect needs stay empty.
#pragma once

#include <string>

namespace dem {

enum Effect : unsigned {
  kDissipation = 1u << 0,  // a dashpot beside the spring: collisions lose energy
  kFriction = 1u << 1,     // tangential spring and slider with history; brings rotation
  kRolling = 1u << 2,      // resistance against rolling, with history
  kAdhesion = 1u << 3,     // linear attraction up to a distance
  kHertz = 1u << 4,        // Hertz contacts instead of linear springs
  kPeriodic = 1u << 5,     // at least one periodic axis
  kShear = 1u << 6,        // Lees-Edwards: the images along y move along x
  kWalls = 1u << 7,        // at least one axis ends in walls
  kGravity = 1u << 8,
  kDrag = 1u << 9,    // Stokes drag of a fluid at rest
  kGrowth = 1u << 10  // radii grow with time
};
using EffectSet = unsigned;

constexpr bool has(EffectSet set, Effect effect) { return (set & effect) != 0; }

// What the force of a contact, of whatever kind, depends on.
constexpr EffectSet kLawEffects = kDissipation | kFriction | kRolling | kAdhesion | kHertz;
// What the force between two particles depends on.
constexpr EffectSet kPairEffects = kLawEffects | kPeriodic | kShear;
// What the motion of a particle under given forces depends on.
constexpr EffectSet kMotionEffects = kFriction | kWalls | kGravity | kDrag;

// Whether a set of pair effects has a meaning, and so a kernel.
constexpr bool is_possible(EffectSet set) {
  if (has(set, kRolling) && !has(set, kFriction)) return false;
  if (has(set, kAdhesion) && has(set, kHertz)) return false;
  return !has(set, kShear) || has(set, kPeriodic);
}

// "dissipation, friction"; "none" for the empty set.
std::string names_of(EffectSet set);

// Throws Error naming the effects that do not go together.
void require_possible(EffectSet set);

}  // namespace dem
