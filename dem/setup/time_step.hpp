// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What time steps follow from the shortest contact (docs/theory/time-step.md).
#pragma once

#include "dem/setup/shortest_contact.hpp"

#include <string>

namespace dem {

constexpr double kFewestStepsPerContact = 10;
constexpr double kUsualStepsPerContact = 50;

// How many times stiffer and as much more damped than a single pair a crowd of contacts may be: the largest eigenvalue
// of the network over that of a pair. It is 4 for a close packing of equal spheres.
constexpr double kCrowd = 8;

// Adhesion: steps that surfaces take to cross its range.
constexpr double kFewestStepsInRange = 10, kUsualStepsInRange = 20;

struct StepLimit {
  double longest = kInfinity;
  std::string reason;  // "the shortest contact lasts 0.1"
};

// The longest time step that is safe. The shortest of
//   accuracy   t_c / 10
//   stability  2 (sqrt(zeta^2 + 1 / q) - zeta) / w, q = kCrowd x crowd_of_springs: 2 / (w sqrt(q)) without damping,
//              1 / (q eta) with much
//   range      crossing / 10 (adhesion)
//   drag       a tenth of the time in which it stops the lightest particle
StepLimit step_limit(const Setup &setup);

// The usual step: t_c / 50 and crossing / 20, or the longest one where that is shorter.
double usual_step(const Setup &setup);

// Throws Error naming the limit if the setup's time step is above it, or not above 0.
void require_time_step(const Setup &setup);

// The fastest approach for which the setup's time step is within the limit; infinite where it does not depend on it.
double fastest_allowed(const Setup &setup);
// What is wrong with a faster one.
std::string speed_fault(const Setup &setup, double approach, double allowed);

}  // namespace dem
