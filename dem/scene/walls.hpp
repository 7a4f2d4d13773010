// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The walls of a scene beside those of its box.
#pragma once

#include "dem/scene/table.hpp"
#include "dem/setup/setup.hpp"

#include <string>

namespace scene {

// Adds the walls of all tables [[wall]] to the setup; those of the same name stand where the stage before has left
// them. `folder` is where relative file names start from.
void read_walls(const Table &top, const std::string &folder, dem::Setup &setup);

}  // namespace scene
