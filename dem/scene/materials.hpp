// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The materials of a scene: the tables [[material]] and [[pair]], and who is made of what.
#pragma once

#include "dem/scene/table.hpp"
#include "dem/setup/setup.hpp"

#include <string>

namespace scene {

// After the effects: the materials and what pairs of them share; sets the effect if there are any. What neither a table
// of these nor that of the effect gives is no number.
void read_materials(const Table &top, dem::Setup &setup);

// The place of the material that a table names; -1 if it names none.
int material_in(const Table &table, const dem::Setup &setup);

// After particles and walls: if all are of one material its numbers become those of the scene, and the effect is off.
// Else all pairs that can meet must have their numbers.
void settle_materials(const Table &top, dem::Setup &setup);

}  // namespace scene
