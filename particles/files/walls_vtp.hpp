// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The walls of a state as VTK PolyData, for ParaView and for pictures.
#pragma once

#include "particles/wall_shapes.hpp"

#include <string>

namespace particles {

// Throws Error if the file cannot be written completely.
void write_walls(const std::string &path, double time, const WallShapes &walls);

// What write_walls has written. Throws Error naming the file if it is something else.
WallShapes read_walls(const std::string &path);

}  // namespace particles
