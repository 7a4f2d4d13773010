// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Size laws as tables of a scene name them.
#pragma once

#include "dem/scene/table.hpp"
#include "packing/size_law.hpp"

#include <string>

namespace scene {

// The law of a table with the key "law" and the parameters of laws. `folder` is where relative file names start from.
packing::SizeLaw read_law(const Table &table, const std::string &folder, int dimension);

}  // namespace scene
