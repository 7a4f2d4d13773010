// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Small systems for the tests of the simulation.
#pragma once

#include "dem/engine/engine.hpp"
#include "dem/setup/setup.hpp"
#include "dem/setup/time_step.hpp"

#include <cmath>
#include <vector>

namespace bodies {

constexpr double kPi = 3.14159265358979323846;

inline double ball_mass(double radius, double density) { return 4 * kPi / 3 * radius * radius * radius * density; }

// Appends a body; vectors have as many components as the setup has dimensions.
inline void add(dem::Setup &setup, const std::vector<double> &center, const std::vector<double> &velocity,
                double radius, double mass, std::vector<double> spin = {}) {
  setup.centers.insert(setup.centers.end(), center.begin(), center.end());
  setup.velocities.insert(setup.velocities.end(), velocity.begin(), velocity.end());
  setup.radii.push_back(radius);
  setup.masses.push_back(mass);
  if (!dem::has(setup.effects, dem::kFriction)) return;
  if (spin.empty()) spin.assign(setup.dimension == 3 ? 3 : 1, 0.0);
  setup.spins.insert(setup.spins.end(), spin.begin(), spin.end());
}

inline void set_walls(dem::Setup &setup, int axis, double low, double high) {
  setup.walled[axis] = true;
  setup.box_min[axis] = low;
  setup.box_max[axis] = high;
  setup.effects |= dem::kWalls;
}

inline void set_periodic(dem::Setup &setup, int axis, double low, double high) {
  setup.periodic[axis] = true;
  setup.box_min[axis] = low;
  setup.box_max[axis] = high;
  setup.effects |= dem::kPeriodic;
}

// Linear contacts with restitution e; 1 leaves out dissipation.
inline void set_linear(dem::Setup &setup, double stiffness, double restitution = 1) {
  setup.contact.stiffness = stiffness;
  setup.contact.restitution = restitution;
  if (restitution < 1) setup.effects |= dem::kDissipation;
}

inline void set_steps_per_contact(dem::Setup &setup, double steps) {
  setup.time_step = dem::shortest_contact(setup).duration / steps;
}

// What a collision looked like from outside.
struct Collision {
  double largest_overlap = 0;  // length
  double duration = 0;         // that the surfaces overlapped
  dem::Snapshot before, after;
};

// Follows the first contact from its start to its end, or `longest` steps; radii over each other as the measurement
// says. The ends of the contact are found between the steps by the speed of the surfaces then.
inline Collision follow_collision(const dem::Setup &setup, size_t longest) {
  const auto engine = dem::make_engine(setup);
  Collision result;
  result.before = engine->snapshot();
  const double smaller = setup.radii.size() > 1 ? std::min(setup.radii[0], setup.radii[1]) : setup.radii[0];
  bool met = false;
  size_t steps = 0;
  for (; steps < longest; steps++) {
    const dem::Measurement m = engine->measure();
    const bool touching = m.contacts + m.wall_contacts > 0;
    if (met && !touching) break;
    met = met || touching;
    result.largest_overlap = std::max(result.largest_overlap, m.largest_overlap * smaller);
    if (touching) result.duration += setup.time_step;
    engine->run(1);
  }
  result.after = engine->snapshot();
  return result;
}

}  // namespace bodies
