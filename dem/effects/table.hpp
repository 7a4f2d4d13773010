// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The table of effects: a row each, and one for each of their numbers. From it come names in messages, the keys of
// scenes and their reference, what goes together, which kernels are built, what is remembered, and what is checked.
#pragma once

#include "dem/base/unit.hpp"
#include "dem/effects/effects.hpp"

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <variant>

namespace dem {

// The numbers that make sense: from low (itself only if closed) to high.
struct Range {
  double low, high;
  bool closed;
  const char *name;  // as in "lies ..."
};
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr Range kAny{-kInfinity, kInfinity, true, "at a number"}, kPositive{0, kLargest, false, "above 0"},
    kNotNegative{0, kLargest, true, "at 0 or above"}, kRestitution{0, 1, false, "in (0, 1]"},
    kPoisson{-1, 0.5, false, "in (-1, 0.5]"};

// Where the engine finds a number, three of them, or letters of axes.
using Place =
    std::variant<double ContactParameters::*, double Physics::*, double (Physics::*)[3], bool (Physics::*)[3]>;

template <class SomePhysics, class Number>
auto &at(SomePhysics &physics, Number ContactParameters::*place) {
  return physics.contact.*place;
}
template <class SomePhysics, class Number>
auto &at(SomePhysics &physics, Number Physics::*place) {
  return physics.*place;
}

// What an effect bears upon.
enum Role : unsigned {
  kInContacts = 1u << 0,  // the force of a contact, of whatever kind
  kInImages = 1u << 1,    // where two particles see each other
  kInMotion = 1u << 2,    // the motion of a particle under given forces
  kOnBodies = 1u << 3,    // those forces: it acts on single particles from outside
  kStateful = 1u << 4,    // has a state that advances once per time step: not with schemes of several stages
  kLossy = 1u << 5,       // energy is lost: not with schemes that go back in time
  kInFloat = 1u << 6      // kernels for states in float: they are there to measure their accuracy
};

struct EffectRow {
  Effect effect;
  const char *name;     // in messages, and of its table in scenes
  const char *meaning;  // null: has no table in scenes
  unsigned roles;
  const char *history = nullptr;  // what a contact remembers from step to step, a vector; null: nothing
  EffectSet needs = 0, excludes = 0;
  const char *why = nullptr;
  const char *(*fault)(const Physics &) = nullptr;  // what is wrong besides, null: nothing
};

inline const char *fault_of_shear(const Physics &physics) {
  return physics.periodic[0] && physics.periodic[1] ? nullptr : "needs the periodic axes x and y";
}

// In the order in which scenes list them.
constexpr EffectRow kEffects[] = {
    {kDissipation, "dissipation", "collisions lose energy", kInContacts | kLossy | kInFloat},
    {kGravity, "gravity", "weight", kOnBodies | kInFloat},
    {kFriction, "friction", "tangential springs with sliders, and rotation", kInContacts | kInMotion | kStateful,
     "slip"},
    {kRolling, "rolling", "resistance against rolling", kInContacts | kStateful, "roll", kFriction, 0,
     "without it particles do not rotate"},
    {kAdhesion, "adhesion", "linear attraction near contact", kInContacts, nullptr, 0, kHertz,
     "it is a law of linear contacts"},
    {kDrag, "drag", "Stokes drag 6 pi eta r v of a fluid at rest", kOnBodies | kLossy},
    {kPeriodic, "periodic", "axes without ends", kInImages | kInFloat},
    {kGrowth, "growth", "all radii grow at constant material density, R (1 + rate t)", kStateful},
    {kHertz, "hertz", "Hertz contacts instead of linear ones", kInContacts | kInFloat},
    {kModulus, "modulus", nullptr, kInContacts | kInFloat, nullptr, 0, kHertz, "it is a law of linear contacts"},
    {kShear, "shear", "Lees-Edwards shear along x with the gradient along y, both periodic", kInImages | kStateful,
     nullptr, kPeriodic, 0, "it moves the images", fault_of_shear},
    {kWalls, "walls", nullptr, kInFloat},
    {kMaterials, "materials", nullptr, kInContacts},
    {kSurfaces, "surfaces", nullptr, kStateful},
};

// In place of an effect: the linear contacts of one stiffness of a scene without other ones.
constexpr Effect kLinear{};
constexpr const char *kLinearName = "contact";

// A number of an effect.
struct Parameter {
  Effect effect;
  const char *key;  // in the effect's table of a scene
  Unit unit;
  const char *fallback;  // what holds if it is left out, in words: what Physics holds at first; or "needed ..."
  Range range;
  const char *meaning;
  Place place;
  // Its key where each material, or each pair of materials, has a number of its own; null: there is one for all.
  const char *in_material = nullptr, *in_pair = nullptr;

  bool needed() const { return std::string_view(fallback).substr(0, 6) == "needed"; }
};

constexpr const char *kNeeded = "needed",
                     *kByEnergy = "that of twice the fastest at the start, falling through the box",
                     *kImpactMeaning = "fastest approach, for the time step";

constexpr Parameter kParameters[] = {
    {kLinear, "stiffness", unit::kStiffness, "needed, or modulus", kPositive,
     "k of the force k d at overlap d, the same for all sizes", &ContactParameters::stiffness, "stiffness"},
    {kModulus, "modulus", unit::kPressure, "needed, or stiffness", kPositive,
     "E: k = pi E r_a r_b / (r_a + r_b), of a rigid wall pi E r", &ContactParameters::modulus, "modulus"},
    {kModulus, "wall_modulus", unit::kPressure, "rigid", kNotNegative, "of the walls (with modulus)",
     &ContactParameters::wall_modulus},
    {kDissipation, "restitution", unit::kPure, kNeeded, kRestitution, "e of every collision, 0 < e <= 1",
     &ContactParameters::restitution, nullptr, "restitution"},
    {kGravity, "acceleration", unit::kAcceleration, kNeeded, kAny, "of free fall", &Physics::gravity},
    {kFriction, "coefficient", unit::kPure, kNeeded, kNotNegative, "tangential over normal force at most",
     &ContactParameters::friction, nullptr, "friction"},
    {kFriction, "stiffness", unit::kPure, "2/7", kPositive, "of the tangential spring over the normal one (linear)",
     &ContactParameters::tangential_stiffness},
    {kRolling, "coefficient", unit::kPure, kNeeded, kNotNegative, "rolling over normal force at most",
     &ContactParameters::rolling_friction, nullptr, "rolling"},
    {kRolling, "stiffness", unit::kPure, "2/7", kPositive, "of the rolling spring over the normal one",
     &ContactParameters::rolling_stiffness},
    {kAdhesion, "force", unit::kForce, kNeeded, kNotNegative, "the pull-off force", &ContactParameters::adhesion_force,
     nullptr, "adhesion"},
    {kAdhesion, "range", unit::kLength, kNeeded, kPositive, "gap of the surfaces at which attraction ends",
     &ContactParameters::adhesion_range},
    {kAdhesion, "impact_speed", unit::kVelocity, kByEnergy, kNotNegative, kImpactMeaning, &Physics::impact_speed},
    {kDrag, "viscosity", unit::kViscosity, kNeeded, kNotNegative, "eta of the fluid", &Physics::viscosity},
    {kPeriodic, "axes", unit::kPure, kNeeded, kAny, "e.g. xyz", &Physics::periodic},
    // Shrinking particles would get lighter, and collisions shorter than the time step allows for.
    {kGrowth, "rate", unit::kRate, kNeeded, kNotNegative, "of the radii, relative to those at the start",
     &Physics::growth_rate},
    {kGrowth, "end", unit::kTime, "never", kAny, "when growth stops", &Physics::growth_end},
    {kHertz, "young_modulus", unit::kPressure, kNeeded, kPositive, "of the particles",
     &ContactParameters::young_modulus, "young_modulus"},
    {kHertz, "poisson_ratio", unit::kPure, kNeeded, kPoisson, "of the particles", &ContactParameters::poisson_ratio,
     "poisson_ratio"},
    {kHertz, "wall_young_modulus", unit::kPressure, "rigid", kNotNegative, "of the walls",
     &ContactParameters::wall_young_modulus},
    {kHertz, "wall_poisson_ratio", unit::kPure, "0", kPoisson, "of the walls", &ContactParameters::wall_poisson_ratio},
    {kHertz, "impact_speed", unit::kVelocity, kByEnergy, kNotNegative, kImpactMeaning, &Physics::impact_speed},
    {kShear, "rate", unit::kRate, kNeeded, kAny, "du_x / dy; particles start with that profile added",
     &Physics::shear_rate},
};

// All effects of a role.
constexpr EffectSet effects_with(Role role) {
  EffectSet set = 0;
  for (const EffectRow &row : kEffects) set |= (row.roles & role) != 0 ? row.effect : 0u;
  return set;
}
constexpr EffectSet kContactEffects = effects_with(kInContacts), kBodyEffects = effects_with(kOnBodies),
                    kImageEffects = effects_with(kInImages),
                    // Batches bring nearest images; only the speed of images is left to pairs.
    kPairEffects = kContactEffects | kShear, kMotionEffects = kBodyEffects | effects_with(kInMotion);

// Whether a set has a meaning, and so kernels, as far as those among `known` can tell.
constexpr bool is_possible(EffectSet set, EffectSet known = ~0u) {
  for (const EffectRow &row : kEffects) {
    if (!has(set, row.effect)) continue;
    if ((row.needs & known & ~set) != 0 || has(set, row.excludes)) return false;
  }
  return true;
}

// The number of an effect with history among all of those; of none: how many there are.
constexpr size_t history_of(Effect effect) {
  size_t number = 0;
  for (const EffectRow &row : kEffects) {
    if (row.effect == effect) return number;
    if (row.history != nullptr) number++;
  }
  return number;
}
constexpr size_t kHistoryCount = history_of(Effect{});

constexpr EffectSet effects_with_history() {
  EffectSet set = 0;
  for (const EffectRow &row : kEffects) set |= row.history != nullptr ? row.effect : 0u;
  return set;
}

constexpr bool is_on(Effect effect, EffectSet set) {
  return effect == kLinear ? !has(set, kHertz | kModulus) : has(set, effect);
}

// The table of a scene that holds the numbers of an effect.
const char *table_of(Effect effect);

const EffectRow *effect_of_name(std::string_view name);  // null if there is none

// "dissipation, friction"; "none" for the empty set.
std::string names_of(EffectSet set);

// "[friction]": effects as scenes name their tables.
std::string tables_of(EffectSet set);

// What is wrong with an effect that is on, or a number of it; empty: nothing.
std::string fault_of(const EffectRow &row, const Physics &physics);
std::string fault_of(const Parameter &parameter, const Physics &physics);

// Throws Error naming the effect or number that is at fault. With several materials their numbers are theirs.
void check_physics(const Physics &physics);

}  // namespace dem
