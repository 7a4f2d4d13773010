// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// The particles of a scene: groups from packings, files, lattices and lists.
#ifndef SIM_SCENE_PARTICLES_HPP
#define SIM_SCENE_PARTICLES_HPP

#include "particles/particle_set.hpp"
#include "sim/dem/setup.hpp"
#include "sim/scene/table.hpp"

#include <string>

namespace scene {

// Appends the particles of one [[particles]] table to the setup. `folder` is where relative file names start from.
// Returns the set as it came from its source: it may bring a box.
app::ParticleSet add_particles(const Table &table, const std::string &folder, dem::Setup &setup);

}  // namespace scene

#endif
