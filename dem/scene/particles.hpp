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
// Returns the set as it came from its source: it may bring a box and masses.
particles::ParticleSet add_particles(const Table &table, const std::string &folder, dem::Setup &setup);

// What such groups share with inflows: their material, -1 for none; the density, of the group or of its material. Throw
// dem::Error where something is given twice or not at all.
int material_of_group(const Table &table, const dem::Setup &setup);
double density_of(const Table &table, const dem::Setup &setup, int material);

}  // namespace scene
