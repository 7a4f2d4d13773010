// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The walls of a simulation where they stand, as faces and lines.
#pragma once

#include "dem/setup/setup.hpp"
#include "dem/state/surfaces.hpp"
#include "particles/particle_set.hpp"
#include "particles/wall_shapes.hpp"

#include <vector>

namespace output {

// The box as the state has it: lines along its sides that are walls or meet images, faces where it ends in walls.
// Planes and cylinders have no end: they are shown as far as the box, or if there is none, as far as the particles and
// all other walls reach. Meshes have lines where their faces end or bend. `walls` are those of the setup, in its order.
particles::WallShapes wall_shapes(const dem::Setup &setup, const std::vector<dem::WallReport> &walls,
                                  const particles::ParticleSet &state);

}  // namespace output
