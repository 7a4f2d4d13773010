// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How the errors of a collision fall with the steps per contact n, derived to leading order: the rms over the moment
// within a step at which it begins. Relative errors, but for e.
#pragma once

#include "dem/setup/scheme.hpp"
#include "programs/accuracy/simulation/power_law.hpp"

namespace accuracy {

// What half a swing lasts under a scheme over what it lasts, exactly, from the angle that a step turns by. It is
// x / arcsin x with x = pi / (2 n) for schemes of one kick per step.
double half_swing(const dem::Scheme &scheme, double steps);

// Elastic contacts of a whole number of steps. A collision ends as it began, in reverse, but for the error of its
// duration: to leading order the errors of meeting and parting cancel.
PowerLaw elastic_duration_law(const dem::Scheme &scheme);
// Factor 0 for schemes of fourth order: only the order is derived.
PowerLaw elastic_restitution_law(const dem::Scheme &scheme);

// Elastic contacts of any number of steps: meeting and parting are independent.
PowerLaw any_step_restitution_law(const dem::Scheme &scheme);
PowerLaw any_step_overlap_law(const dem::Scheme &scheme);

// Contacts of a whole number of steps with a dashpot that takes the velocities of half a step ago, for schemes of one
// kick per step.
PowerLaw damped_duration_law(double restitution);
PowerLaw damped_restitution_law(double restitution);
PowerLaw damped_overlap_law(double restitution);

}  // namespace accuracy
