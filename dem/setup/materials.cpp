// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which materials of a setup meet, and what every setup with several must fulfil.
#include "dem/setup/materials.hpp"

#include "dem/base/error.hpp"
#include "dem/effects/table.hpp"

#include <algorithm>

namespace dem {
namespace {

void check_numbers(const Setup &setup, const ContactParameters &numbers, const char *Parameter::*key,
                   const std::string &of) {
  Physics physics = setup;
  physics.contact = numbers;
  for (const Parameter &parameter : kParameters) {
    if (parameter.*key == nullptr || !is_on(parameter.effect, setup.effects)) continue;
    const std::string fault = fault_of(parameter, physics);
    if (!fault.empty()) throw Error(std::string(parameter.*key).append(" of ").append(of).append(" ").append(fault));
  }
}

}  // namespace

std::vector<int> materials_of_walls(const Setup &setup) {
  std::vector<int> materials;
  for (size_t wall = 0; wall < 2 * static_cast<size_t>(setup.dimension); wall++) {
    if (setup.walled[wall / 2]) materials.push_back(setup.wall_materials[wall]);
  }
  for (const WallBody &wall : setup.walls) materials.push_back(wall.material);
  return materials;
}

std::vector<std::pair<size_t, size_t>> meetings(const Setup &setup) {
  const size_t count = setup.materials.size();
  std::vector<bool> of_particles(count), of_walls(count + 1);
  for (const ParticleArrays *particles : {static_cast<const ParticleArrays *>(&setup), &setup.expected}) {
    for (const uint8_t id : particles->material_ids) of_particles[id] = true;
  }
  for (const int material : materials_of_walls(setup)) {
    of_walls[material < 0 ? count : static_cast<size_t>(material)] = true;
  }
  std::vector<std::pair<size_t, size_t>> result;
  for (size_t a = 0; a < count; a++) {
    for (size_t b = 0; b <= count && of_particles[a]; b++) {
      if (of_walls[b] || (b < count && of_particles[b])) result.emplace_back(a, b);
    }
  }
  return result;
}

std::string names_of(const std::vector<Material> &materials) {
  std::string names;
  for (const Material &material : materials) names += (names.empty() ? "" : ", ") + material.name;
  return names;
}

std::string name_of_pair(const Setup &setup, size_t a, size_t b) {
  return setup.materials[a].name + " with " + (b < setup.materials.size() ? setup.materials[b].name : "walls");
}

void check_materials(const Setup &setup) {
  const size_t count = setup.materials.size();
  if (count == 0 || count > kMostMaterials) {
    throw Error("the number of materials is " + std::to_string(count) + ", not 1 to " + std::to_string(kMostMaterials));
  }
  if (setup.pairs.size() != count * (count + 1)) {
    throw Error("pairs of materials: " + std::to_string(setup.pairs.size()) + " where " +
                std::to_string(count * (count + 1)) + " are needed");
  }
  for (size_t i = 0; i < setup.material_ids.size(); i++) {
    if (setup.material_ids[i] < count) continue;
    throw Error("particle " + std::to_string(i) + " is of material " + std::to_string(setup.material_ids[i]) +
                ", and there are " + std::to_string(count));
  }
  for (const int material : materials_of_walls(setup)) {
    if (material >= static_cast<int>(count)) throw Error("a wall is of material " + std::to_string(material));
  }
  for (const Material &material : setup.materials)
    check_numbers(setup, material.contact, &Parameter::in_material, material.name);
  for (const auto &[a, b] : meetings(setup))
    check_numbers(setup, setup.pairs[setup.pair_of(a, b)], &Parameter::in_pair, name_of_pair(setup, a, b));
}

}  // namespace dem
