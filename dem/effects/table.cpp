// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What is said and checked by the table of effects.
#include "dem/effects/table.hpp"

#include "dem/base/error.hpp"

namespace dem {
namespace {

// The names of a set in the order of its bits.
std::string list(EffectSet set, const char *before, const char *after, const char *between) {
  std::string result;
  for (EffectSet bit = 1; bit != 0; bit <<= 1) {
    for (const EffectRow &row : kEffects) {
      if (row.effect != (set & bit)) continue;
      result += (result.empty() ? "" : between) + std::string(before) + row.name + after;
    }
  }
  return result;
}

// "lies above 0, not at -1"; empty if it lies there.
std::string fault_in(const Range &range, double value) {
  const bool above = range.closed ? value >= range.low : value > range.low;
  if (above && value <= range.high) return "";
  return std::string("lies ") + range.name + ", not at " + text(value);
}

std::string fault_in(const Range &range, const double (&vector)[3]) {
  std::string fault;
  for (const double value : vector) {
    if (fault.empty()) fault = fault_in(range, value);
  }
  return fault;
}

std::string fault_in(const Range &, const bool (&axes)[3]) {
  return axes[0] || axes[1] || axes[2] ? "" : "names no axis";
}

}  // namespace

const char *table_of(Effect effect) {
  for (const EffectRow &row : kEffects) {
    if (row.effect == effect && row.meaning != nullptr) return row.name;
  }
  return kLinearName;
}

const EffectRow *effect_of_name(std::string_view name) {
  for (const EffectRow &row : kEffects) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

std::string names_of(EffectSet set) {
  const std::string names = list(set, "", "", ", ");
  return names.empty() ? "none" : names;
}

std::string tables_of(EffectSet set) { return list(set, "[", "]", " and "); }

std::string fault_of(const EffectRow &row, const Physics &physics) {
  if (const char *fault = row.fault != nullptr ? row.fault(physics) : nullptr) return fault;
  const EffectSet missing = row.needs & ~physics.effects, clashing = row.excludes & physics.effects;
  if (missing != 0) return "needs " + tables_of(missing) + ": " + row.why;
  if (clashing != 0) return "does not go together with " + tables_of(clashing) + ": " + row.why;
  return "";
}

std::string fault_of(const Parameter &parameter, const Physics &physics) {
  return std::visit([&](auto place) { return fault_in(parameter.range, at(physics, place)); }, parameter.place);
}

void check_physics(const Physics &physics) {
  for (const EffectRow &row : kEffects) {
    const std::string fault = is_on(row.effect, physics.effects) ? fault_of(row, physics) : "";
    if (!fault.empty()) throw Error(std::string(row.name) + " " + fault);
  }
  for (const Parameter &parameter : kParameters) {
    const bool several = has(physics.effects, kMaterials);
    if (several && (parameter.in_material != nullptr || parameter.in_pair != nullptr)) continue;
    const std::string fault = is_on(parameter.effect, physics.effects) ? fault_of(parameter, physics) : "";
    if (!fault.empty()) throw Error(std::string(table_of(parameter.effect)) + "." + parameter.key + " " + fault);
  }
}

}  // namespace dem
