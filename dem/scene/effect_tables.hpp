// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The tables of a scene that switch effects on, and the contact law.
#pragma once

#include "dem/scene/table.hpp"
#include "dem/setup/setup.hpp"

namespace scene {

// Sets the effects of the setup, all but walls, and their numbers; also the periodic axes.
void read_effects(const Table &top, dem::Setup &setup);

// Adds u_x = rate (y - middle of the box) to the velocities, if there is shear; less the profile of `former`, the rate
// that they have already.
void add_shear_profile(dem::Setup &setup, double former = 0);

}  // namespace scene
