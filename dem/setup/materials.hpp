// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which materials of a setup meet, and what every setup with several must fulfil.
#pragma once

#include "dem/setup/setup.hpp"

#include <string>
#include <utility>
#include <vector>

namespace dem {

constexpr size_t kMostMaterials = 255;  // one byte tells which, or that a wall has none

// Those of all walls that there are; -1: none.
std::vector<int> materials_of_walls(const Setup &setup);

// All materials a and b of which particles of a can meet particles or walls of b; b is materials.size() for walls of no
// material. Also before the particles have got the effect.
std::vector<std::pair<size_t, size_t>> meetings(const Setup &setup);

// "glass, steel".
std::string names_of(const std::vector<Material> &materials);

// "glass with steel", "glass with walls".
std::string name_of_pair(const Setup &setup, size_t a, size_t b);

// Throws Error naming the material or pair that is at fault. With the effect only.
void check_materials(const Setup &setup);

}  // namespace dem
