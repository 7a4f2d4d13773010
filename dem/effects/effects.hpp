// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The effects a simulation can have, as a set that is known when a kernel is compiled, and their numbers.
//
// An effect that is not in the set costs nothing: the kernels test the set with `if constexpr`, and arrays that only
// this effect needs stay empty. What there is to say about each effect stands in table.hpp.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace dem {

// The bits stand in checkpoints.
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
  kDrag = 1u << 9,        // Stokes drag of a fluid at rest
  kGrowth = 1u << 10,     // radii grow with time
  kModulus = 1u << 11,    // linear springs whose stiffness follows from a modulus and the sizes
  kMaterials = 1u << 12,  // particles and walls of several materials
  kSurfaces = 1u << 13    // walls beside those of the box
};
using EffectSet = unsigned;

// Whether the set has one of these effects.
constexpr bool has(EffectSet set, EffectSet effects) { return (set & effects) != 0; }

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct ContactParameters {
  double stiffness = 0;                   // k, force per length, of every contact (linear)
  double modulus = 0;                     // E of the particles (modulus)
  double wall_modulus = 0;                // 0: rigid walls
  double restitution = 1;                 // e (dissipation)
  double friction = 0;                    // mu
  double tangential_stiffness = 2.0 / 7;  // k_t / k (linear friction): both springs of a sphere then swing alike
  double rolling_friction = 0;
  double rolling_stiffness = 2.0 / 7;  // k_r / k
  double adhesion_force = 0;           // F_a
  double adhesion_range = 0;           // h
  double young_modulus = 0;            // of the particles (Hertz)
  double poisson_ratio = 0;            // of the particles
  double wall_young_modulus = 0;       // 0: rigid walls
  double wall_poisson_ratio = 0;
};

// What a partner of contacts is made of: of the numbers those count that a material has (table.hpp).
struct Material {
  std::string name;
  double density = 0;  // 0: not given
  ContactParameters contact;
};

// What acts on particles, in any consistent units. Members of effects that are off mean nothing. What holds here at
// first is what a scene gets that says nothing.
struct Physics {
  EffectSet effects = 0;
  ContactParameters contact;
  bool walled[3]{}, periodic[3]{};  // per axis, at most one of them
  double gravity[3]{};
  double viscosity = 0;           // of the fluid: Stokes drag 6 pi eta r v (drag)
  double growth_rate = 0;         // of all radii relative to those at the start, per time (growth)
  double growth_end = kInfinity;  // time when growth stops
  double shear_rate = 0;          // du_x / dy (shear)
  double impact_speed = 0;        // the fastest approach, for the time step; 0: by the energy at the start
                                  // (hertz, adhesion)

  // Several materials in place of `contact` (materials).
  std::vector<Material> materials;
  std::vector<ContactParameters> pairs;              // what two partners share: pairs[pair_of(a, b)]
  int wall_materials[6] = {-1, -1, -1, -1, -1, -1};  // by wall; -1: as `contact` says of walls

  // Of a particle of material a with material b; b = materials.size() stands for walls of no material.
  size_t pair_of(size_t a, size_t b) const { return a * (materials.size() + 1) + b; }
};

}  // namespace dem
