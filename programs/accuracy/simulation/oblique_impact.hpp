// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Oblique impacts of a rough sphere on a wall, by the equation of motion and by the engine.
#pragma once

#include "dem/setup/setup.hpp"

#include <cstddef>

namespace accuracy {

// Against the rigid wall x = 0 from the right, with tangential speed along y and spin about z, so that the surface
// slips with tangential - radius * spin.
struct Impact {
  double radius, mass;
  double normal, tangential, spin;
};

struct Motion {
  double normal, tangential, spin;
};

// The motion after an impact of the setup's law, Hertz or linear, with friction: the equation of motion in 400 000
// steps of a contact that lasts about so long. It shares no code with the engine. Without a dashpot the spring bears
// the slider's limit alone.
Motion integrate(const dem::Setup &setup, const Impact &impact, double duration);

// Impacts of the engine that begin at any moment within a time step.
struct RoughCase {
  double steps = 50;  // per contact
  double restitution = 0.8, friction = 0.5;
  double slip = 1;  // over the normal speed: it sticks for a part of the contact and slides for the rest
  size_t impacts = 400;
};

// rms over all impacts of the error of the slip afterwards, over the normal speed.
double slip_error(const RoughCase &what);

}  // namespace accuracy
