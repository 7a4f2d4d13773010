// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The regions of a scene: where particles come in, go out and are counted.
#pragma once

#include "dem/scene/table.hpp"
#include "dem/setup/setup.hpp"

#include <string>
#include <vector>

namespace scene {

// After materials and the box: the tables [[inflow]] and [[removal]], and what particles are to be expected.
void read_exchange(const Table &top, const std::string &folder, dem::Setup &setup);

// The tables [[region]].
std::vector<dem::Region> read_regions(const Table &top, int dimension);

}  // namespace scene
