// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The state of a simulation as a set of particles with velocity, mass and, where particles rotate, spin.
#pragma once

#include "dem/engine/engine.hpp"
#include "dem/setup/setup.hpp"
#include "particles/particle_set.hpp"

#include <cstdint>

namespace output {

// `setup` gives the box.
particles::ParticleSet picture_of(const dem::Setup &setup, uint64_t step, dem::Snapshot state);

}  // namespace output
