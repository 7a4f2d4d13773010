// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The tables of a scene that switch effects on, and the contact law.
#include "dem/scene/effect_tables.hpp"

#include "dem/effects/table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace scene {
namespace {

void read_parameter(const Table &table, const dem::Parameter &parameter, const dem::Setup &, double &number) {
  number = parameter.needed() ? table.number(parameter.key) : table.number(parameter.key, number);
}

void read_parameter(const Table &table, const dem::Parameter &parameter, const dem::Setup &setup, double (&vector)[3]) {
  const std::vector<double> numbers = table.vector(parameter.key, static_cast<size_t>(setup.dimension));
  std::copy(numbers.begin(), numbers.end(), vector);
}

void read_parameter(const Table &table, const dem::Parameter &parameter, const dem::Setup &setup, bool (&axes)[3]) {
  table.axes(parameter.key, setup.dimension, axes);
}

// What materials may give, or a table that is not there because they give all of it. No number stands for what they
// have to give.
bool is_left_to_materials(const dem::Parameter &parameter, const std::optional<Table> &table, dem::Setup &setup) {
  if (table && table->has(parameter.key)) return false;
  const bool theirs = parameter.needed() && (parameter.in_material != nullptr || parameter.in_pair != nullptr);
  if (theirs) at(setup, std::get<double dem::ContactParameters::*>(parameter.place)) = std::nan("");
  return theirs || !table;
}

}  // namespace

void read_effects(const Table &top, dem::Setup &setup) {
  if (top.has("hertz") && top.has("contact")) top.fail("hertz", "stands instead of [contact]");
  const std::vector<Table> materials = top.parts("material");
  if (!top.has("hertz") && !top.has("contact") && materials.empty()) {
    top.fail("contact", "a scene needs [contact] or [hertz], or [[material]]");
  }
  for (const dem::EffectRow &row : dem::kEffects) {
    if (row.meaning != nullptr && top.has(row.name)) setup.effects |= row.effect;
  }
  if (const auto contact = top.part(dem::kLinearName)) {
    if (contact->has("modulus")) setup.effects |= dem::kModulus;
    if (contact->has("modulus") && contact->has("stiffness")) contact->fail("modulus", "stands instead of stiffness");
  }
  for (const Table &material : materials) {
    if (material.has("modulus") && !has(setup.effects, dem::kHertz)) setup.effects |= dem::kModulus;
  }
  for (const dem::Parameter &parameter : dem::kParameters) {
    if (!is_on(parameter.effect, setup.effects)) continue;
    const auto table = top.part(table_of(parameter.effect));
    if (!materials.empty() && is_left_to_materials(parameter, table, setup)) continue;
    std::visit([&](auto place) { read_parameter(*table, parameter, setup, at(setup, place)); }, parameter.place);
    const std::string fault = fault_of(parameter, setup);
    if (!fault.empty()) table->fail(parameter.key, fault);
  }
  for (const dem::EffectRow &row : dem::kEffects) {
    const std::string fault = has(setup.effects, row.effect) ? fault_of(row, setup) : "";
    if (!fault.empty()) top.fail(row.name, fault);
  }
}

void add_shear_profile(dem::Setup &setup, double former) {
  if (!has(setup.effects, dem::kShear)) return;
  const auto dimension = static_cast<size_t>(setup.dimension);
  const double middle = (setup.box_min[1] + setup.box_max[1]) / 2;
  for (size_t i = 0; i < setup.count(); i++) {
    setup.velocities[i * dimension] += (setup.shear_rate - former) * (setup.centers[i * dimension + 1] - middle);
  }
}

}  // namespace scene
