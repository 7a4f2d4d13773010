// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Walls in a scene for POV-Ray: thin lines, and faces that one sees through.
#pragma once

#include "particles/clipping.hpp"
#include "particles/wall_shapes.hpp"

#include <string>

namespace draw {

// Widens the view to hold walls: meshes and cylinders as a whole; of planes and of the box, which may be far larger
// than what is in it, those ends that are near.
void hold_walls(particles::Bounds &view, const particles::WallShapes &walls, int dimension);

// Planes and the box as far as the view reaches.
std::string povray_walls(const particles::WallShapes &walls, const particles::Bounds &view, int dimension);

}  // namespace draw
