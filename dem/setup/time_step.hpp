// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How long the shortest contact lasts, and what time steps follow from it.
#pragma once

#include "dem/setup/setup.hpp"

namespace dem {

// What a step may be at most, as a share of the shortest contact. A sphere among twelve equal ones swings at up to
// sqrt(24 k / m) = 10.9 / t_c, and the Verlet scheme is stable below 2 over that: t_c / 5.4. Half of it.
constexpr double kFewestStepsPerContact = 10;
constexpr double kUsualStepsPerContact = 50;

// The time that the shortest contact of any two particles lasts, or of one with a wall.
//   linear  t_c = sqrt(mu (pi^2 + ln^2 e) / k), of the two lightest particles; shorter if the tangential spring is
//           stiffer: it moves the mass mu / (1 + 1 / q), I = q m r^2
//   Hertz   t_c = 2.943275 (mu^2 / (R v))^(1/5) (15 / (16 E*))^(2/5) at the impact speed v, without dissipation
// Infinite without particles that can move. Throws Error if Hertz contacts come without any speed.
double shortest_contact(const Setup &setup);

// Throws Error naming the limit if the setup's time step is above it, or not above 0.
void require_time_step(const Setup &setup);

}  // namespace dem
