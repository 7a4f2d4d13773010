// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Random centres to start a packing from.
#pragma once

#include "packing/box.hpp"
#include "packing/random.hpp"

namespace packing {

// Throws the particles of `set` (radii given, box as `box`) evenly into the box, large ones first. A centre that falls
// into a much larger particle is thrown again: relaxation could not bring it out in a few sweeps. All other overlaps
// stay.
void place_at_random(const Box &box, Random &random, particles::ParticleSet &set);

}  // namespace packing
