// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the particles of a group come from.
#pragma once

#include "dem/scene/table.hpp"
#include "dem/setup/setup.hpp"
#include "particles/particle_set.hpp"

#include <string>

namespace scene {

// Centres and radii of one [[particles]] table, and the box if the source has one. The periodic axes of the setup must
// be known: a packing is made with them.
particles::ParticleSet read_source(const Table &table, const std::string &folder, const dem::Setup &setup);

}  // namespace scene
