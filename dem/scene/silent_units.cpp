// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "dem/scene/silent_units.hpp"

#include <string>

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

}  // namespace

void refuse_silent_units(const Table &top) {
  if (!top.has_units()) return;
  for (const Table &group : top.parts("particles")) {
    const bool weighs = group.has("density") || has_heavy_material(top, group) || group.flag("fixed", false);
    if (!weighs)
      group.fail("density", "is needed beside numbers with units, else it would be 1 in SI, a thousandth of water's");
    const auto pack = group.part("pack");
    if (pack && pack->text("law", "") != "table" && !group.has("radius"))
      group.fail("radius", "is needed beside numbers with units, else the smallest would be 1 m");
  }
}

}  // namespace scene
