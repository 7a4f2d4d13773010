// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A radius or density of 1 that nobody asked for is harmless among bare numbers, and nonsense beside millimetres.
#pragma once

#include "dem/scene/table.hpp"

namespace scene {

// Throws dem::Error naming the group or inflow that leaves out its density, or with a size law its radius, in a scene
// with units.
// Of files, whose masses are not known yet, the density is left to the second function.
void refuse_silent_units(const Table &top);
void refuse_silent_density(const Table &top, const Table &group);

}  // namespace scene
