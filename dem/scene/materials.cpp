// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The materials of a scene.
#include "dem/scene/materials.hpp"

#include "dem/base/error.hpp"
#include "dem/effects/table.hpp"
#include "dem/setup/materials.hpp"

#include <algorithm>
#include <cmath>

namespace scene {
namespace {

using dem::ContactParameters;

// Reads those numbers of the table that it has, and checks them; `key` is what a parameter is called there.
void read_numbers(const Table &table, const char *dem::Parameter::*key, const dem::Setup &setup,
                  ContactParameters &numbers) {
  for (const dem::Parameter &parameter : dem::kParameters) {
    const char *name = parameter.*key;
    if (name == nullptr || !table.has(name)) continue;
    if (!is_on(parameter.effect, setup.effects)) {
      if (parameter.effect == dem::kLinear)
        table.fail(name, "stands beside a modulus or [hertz]: give only one of them");
      table.fail(name, std::string("means nothing without [") + table_of(parameter.effect) + "]");
    }
    dem::Physics physics = setup;
    at(physics, std::get<double ContactParameters::*>(parameter.place)) = table.number(name);
    const std::string fault = fault_of(parameter, physics);
    if (!fault.empty()) table.fail(name, fault);
    numbers.*std::get<double ContactParameters::*>(parameter.place) = table.number(name);
  }
}

// Throws unless all numbers that an effect needs are there.
template <class Fail>
void require_numbers(const ContactParameters &numbers, const char *dem::Parameter::*key, const dem::Setup &setup,
                     Fail fail) {
  for (const dem::Parameter &parameter : dem::kParameters) {
    if (parameter.*key == nullptr || !is_on(parameter.effect, setup.effects)) continue;
    if (std::isnan(numbers.*std::get<double ContactParameters::*>(parameter.place))) fail(parameter);
  }
}

dem::Material read_material(const Table &table, const dem::Setup &setup) {
  dem::Material material;
  material.name = table.text("name", "");
  if (material.name.empty()) table.fail("name", "each material needs a name");
  const auto same = [&](const dem::Material &other) { return other.name == material.name; };
  if (std::any_of(setup.materials.begin(), setup.materials.end(), same)) {
    table.fail("name", "there are two materials '" + material.name + "'");
  }
  material.density = table.number("density", 0, Unit{-setup.dimension, 0, 1});
  if (table.has("density") && !(material.density > 0)) {
    table.fail("density", dem::text(material.density) + " is not above 0");
  }
  material.contact = setup.contact;
  read_numbers(table, &dem::Parameter::in_material, setup, material.contact);
  require_numbers(material.contact, &dem::Parameter::in_material, setup, [&](const dem::Parameter &parameter) {
    table.fail(parameter.in_material,
               std::string("is needed, here or for all materials in [") + table_of(parameter.effect) + "]");
  });
  return material;
}

void read_pair(const Table &table, dem::Setup &setup, std::vector<bool> &given) {
  std::vector<std::string> names;
  for (const dem::Material &material : setup.materials) names.push_back(material.name);
  const std::vector<std::string> of = table.choices("materials", names);
  if (of.size() != 2) table.fail("materials", "a pair is of two materials, not of " + std::to_string(of.size()));
  const auto place = [&](const std::string &name) {
    return static_cast<size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  const size_t a = place(of[0]), b = place(of[1]);
  if (given[setup.pair_of(a, b)]) table.fail("materials", "the pair " + of[0] + ", " + of[1] + " is given twice");
  given[setup.pair_of(a, b)] = given[setup.pair_of(b, a)] = true;
  read_numbers(table, &dem::Parameter::in_pair, setup, setup.pairs[setup.pair_of(a, b)]);
  setup.pairs[setup.pair_of(b, a)] = setup.pairs[setup.pair_of(a, b)];
}

bool has_wall_of(const dem::Setup &setup, size_t material) {
  const std::vector<int> walls = dem::materials_of_walls(setup);
  return std::find(walls.begin(), walls.end(), static_cast<int>(material)) != walls.end();
}

// Whether one law holds between particles and another between particles and walls, as without materials.
bool is_one_for_all(const Table &top, const dem::Setup &setup) {
  const auto meetings = dem::meetings(setup);
  const auto a = static_cast<size_t>(setup.first_material()), none = setup.materials.size();
  // Walls of the material beside walls of none are of two laws.
  const auto is_met = [&](size_t other) {
    return std::find(meetings.begin(), meetings.end(), std::pair(a, other)) != meetings.end();
  };
  if (is_met(none) && has_wall_of(setup, a)) return false;
  return std::all_of(meetings.begin(), meetings.end(), [&](const std::pair<size_t, size_t> &pair) {
    return pair.first == a && (pair.second == a || (pair.second == none && !top.has("pair")));
  });
}

void put_one_for_all(dem::Setup &setup) {
  const auto a = static_cast<size_t>(setup.first_material());
  const bool of_walls = has_wall_of(setup, a);
  const ContactParameters own = setup.materials[a].contact;
  setup.contact = setup.pairs[setup.pair_of(a, a)];
  setup.contact.stiffness = own.stiffness;
  setup.contact.modulus = own.modulus;
  setup.contact.young_modulus = own.young_modulus;
  setup.contact.poisson_ratio = own.poisson_ratio;
  if (of_walls) {
    setup.contact.wall_modulus = own.modulus;
    setup.contact.wall_young_modulus = own.young_modulus;
    setup.contact.wall_poisson_ratio = own.poisson_ratio;
  }
  setup.effects &= ~dem::EffectSet{dem::kMaterials};
  setup.materials.clear();
  setup.pairs.clear();
  setup.material_ids.clear();
  setup.expected.material_ids.clear();
  for (dem::Inflow &inflow : setup.inflows) inflow.material = -1;
  std::fill(std::begin(setup.wall_materials), std::end(setup.wall_materials), -1);
  for (dem::WallBody &wall : setup.walls) wall.material = -1;
}

}  // namespace

void read_materials(const Table &top, dem::Setup &setup) {
  for (const Table &table : top.parts("material")) setup.materials.push_back(read_material(table, setup));
  const size_t count = setup.materials.size();
  if (count > dem::kMostMaterials) top.fail("material", std::to_string(count) + " materials are more than 255");
  if (count == 0 && top.has("pair")) top.fail("pair", "needs [[material]]: a pair is of two of them");
  if (count == 0) return;
  setup.effects |= dem::kMaterials;
  setup.pairs.assign(count * (count + 1), setup.contact);
  std::vector<bool> given(count * (count + 1));
  for (const Table &table : top.parts("pair")) read_pair(table, setup, given);
}

int material_in(const Table &table, const dem::Setup &setup) {
  if (!table.has("material")) return -1;
  std::vector<std::string> names;
  for (const dem::Material &material : setup.materials) names.push_back(material.name);
  if (names.empty()) table.fail("material", "the scene has no [[material]]");
  const std::string name = table.choice("material", names);
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

void settle_materials(const Table &top, dem::Setup &setup) {
  if (!has(setup.effects, dem::kMaterials)) return;
  for (const auto &[a, b] : dem::meetings(setup)) {
    const std::string pair = dem::name_of_pair(setup, a, b);
    require_numbers(
        setup.pairs[setup.pair_of(a, b)], &dem::Parameter::in_pair, setup, [&](const dem::Parameter &parameter) {
          top.fail("pair", std::string(parameter.in_pair) + " of " + pair + " is given neither in a [[pair]]" +
                               " nor for all in [" + table_of(parameter.effect) + "]");
        });
  }
  if (is_one_for_all(top, setup)) put_one_for_all(setup);
}

}  // namespace scene
