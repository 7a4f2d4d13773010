// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A radius or density of 1 that nobody asked for is harmless among bare numbers, and nonsense beside millimetres.
#pragma once

#include "dem/scene/table.hpp"

namespace scene {

// Throws dem::Error naming the group that leaves out its density, or a packing its radius, in a scene with units.
void refuse_silent_units(const Table &top);

}  // namespace scene
