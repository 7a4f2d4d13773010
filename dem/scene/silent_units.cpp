// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "dem/scene/silent_units.hpp"

#include <string>
#include <vector>

namespace scene {
namespace {

// Whether the group's material has a density for it.
bool has_heavy_material(const Table &top, const Table &group) {
  const std::string name = group.text("material", "");
  for (const Table &material : top.parts("material")) {
    if (material.has("density") && material.text("name", "") == name) return true;
  }
  return false;
}

// Of a table with a size law.
void refuse_silent_radius(const Table &group, const char *sizes) {
  const auto law = group.part(sizes);
  if (law && law->text("law", "") != "table" && !group.has("radius"))
    group.fail("radius", "is needed beside numbers with units, else the smallest would be 1 m");
}

}  // namespace

void refuse_silent_density(const Table &top, const Table &group) {
  if (!top.has_units() || group.flag("fixed", false) || group.has("density") || has_heavy_material(top, group)) return;
  group.fail("density", "is needed beside numbers with units, else it would be 1 in SI, a thousandth of water's");
}

void refuse_silent_units(const Table &top) {
  if (!top.has_units()) return;
  std::vector<Table> places = top.parts(kStage);
  places.push_back(top);
  for (const Table &place : places) {
    for (const Table &group : place.parts("particles")) {
      if (!group.has("file")) refuse_silent_density(top, group);
      refuse_silent_radius(group, "pack");
    }
    for (const Table &inflow : place.parts("inflow")) {
      refuse_silent_density(top, inflow);
      refuse_silent_radius(inflow, "radii");
    }
  }
}

}  // namespace scene
