// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The particles of a scene: groups from packings, files, lattices and lists.
#pragma once

#include "dem/scene/table.hpp"
#include "dem/setup/setup.hpp"
#include "particles/particle_set.hpp"

#include <string>

namespace scene {

// Appends the particles of one [[particles]] table to the setup. `folder` is where relative file names start from.
// Returns the set as it came from its source: it may bring a box.
particles::ParticleSet add_particles(const Table &table, const std::string &folder, dem::Setup &setup);

}  // namespace scene
