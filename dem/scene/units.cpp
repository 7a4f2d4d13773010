// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Numbers with units, turned to SI.
#include "dem/scene/units.hpp"

#include "dem/base/error.hpp"
#include "dem/scene/suggestion.hpp"

#include <charconv>
#include <cmath>
#include <vector>

namespace scene {
namespace {

struct NamedUnit {
  const char *name;
  double si;
  Unit unit;
};

constexpr NamedUnit kUnits[] = {{"m", 1, kLength},        {"km", 1e3, kLength},    {"cm", 1e-2, kLength},
                                {"mm", 1e-3, kLength},    {"um", 1e-6, kLength},   {"nm", 1e-9, kLength},
                                {"s", 1, kTime},          {"ms", 1e-3, kTime},     {"us", 1e-6, kTime},
                                {"ns", 1e-9, kTime},      {"min", 60, kTime},      {"h", 3600, kTime},
                                {"kg", 1, kMass},         {"g", 1e-3, kMass},      {"mg", 1e-6, kMass},
                                {"t", 1e3, kMass},        {"N", 1, kForce},        {"mN", 1e-3, kForce},
                                {"kN", 1e3, kForce},      {"MN", 1e6, kForce},     {"Pa", 1, kPressure},
                                {"mPa", 1e-3, kPressure}, {"kPa", 1e3, kPressure}, {"MPa", 1e6, kPressure},
                                {"GPa", 1e9, kPressure},  {"J", 1, kEnergy},       {"mJ", 1e-3, kEnergy},
                                {"Hz", 1, kRate},         {"rad", 1, kPure},       {"deg", 0.017453292519943295, kPure},
                                {"%", 1e-2, kPure}};

// With a u for the micro sign, which has two codes: as such, and as the Greek letter.
std::string with_plain_micro(std::string_view name) {
  for (const std::string_view micro : {"\u00b5", "\u03bc"}) {
    if (name.substr(0, micro.size()) == micro) return "u" + std::string(name.substr(micro.size()));
  }
  return std::string(name);
}

const NamedUnit &unit_of_name(std::string_view written) {
  const std::string name = with_plain_micro(written);
  std::vector<std::string> known;
  for (const NamedUnit &unit : kUnits) {
    if (name == unit.name) return unit;
    known.emplace_back(unit.name);
  }
  throw dem::Error("'" + std::string(written) + "' is no unit" + suggestion(name, known));
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

// One unit with its power, such as "s^2", times or divided.
void multiply(std::string_view factor, bool divided, double &value, Unit &unit) {
  const size_t caret = factor.find('^');
  const NamedUnit &named = unit_of_name(factor.substr(0, caret));
  int power = 1;
  if (caret != std::string_view::npos) {
    const std::string_view digits = factor.substr(caret + 1);
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), power);
    if (result.ec != std::errc() || result.ptr != digits.data() + digits.size()) {
      throw dem::Error("'" + std::string(digits) + "' is no power of a unit");
    }
  }
  if (divided) power = -power;
  value *= std::pow(named.si, power);
  unit.length += power * named.unit.length;
  unit.time += power * named.unit.time;
  unit.mass += power * named.unit.mass;
}

std::string powers(Unit unit) {
  std::string result;
  const struct {
    const char *name;
    int power;
  } parts[] = {{"kg", unit.mass}, {"m", unit.length}, {"s", unit.time}};
  for (const auto &[name, power] : parts) {
    if (power == 0) continue;
    result += (result.empty() ? "" : " ") + std::string(name);
    if (power != 1) result += "^" + std::to_string(power);
  }
  return result;
}

}  // namespace

double in_si(std::string_view text, Unit wanted) {
  const std::string_view whole = without_blanks(text);
  double value = 0;
  const auto number = std::from_chars(whole.data(), whole.data() + whole.size(), value);
  if (number.ec != std::errc() || !std::isfinite(value)) {
    throw dem::Error("'" + std::string(text) + "' does not begin with a number");
  }
  std::string_view rest = whole.substr(static_cast<size_t>(number.ptr - whole.data()));
  Unit unit;
  bool divided = false;
  while (!(rest = without_blanks(rest)).empty()) {
    const size_t end = std::min(rest.find_first_of(" /*"), rest.size());
    if (end > 0) multiply(rest.substr(0, end), divided, value, unit);
    divided = end < rest.size() && rest[end] == '/';
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (divided && without_blanks(rest).empty()) throw dem::Error("'" + std::string(text) + "' ends with '/'");
  }
  if (!(unit == wanted)) {
    throw dem::Error("'" + std::string(text) + "' is in " + describe(unit) + " where " + describe(wanted) +
                     " is wanted");
  }
  return value;
}

std::string describe(Unit unit) {
  const struct {
    Unit unit;
    const char *name;
  } names[] = {{kPure, "a pure number"}, {kLength, "length (m)"},          {kTime, "time (s)"},
               {kMass, "mass (kg)"},     {kVelocity, "velocity (m/s)"},    {kAcceleration, "acceleration (m/s^2)"},
               {kForce, "force (N)"},    {kStiffness, "stiffness (N/m)"},  {kPressure, "pressure (Pa)"},
               {kEnergy, "energy (J)"},  {kViscosity, "viscosity (Pa s)"}, {kDensity, "density (kg/m^3)"},
               {kRate, "per time (1/s)"}};
  for (const auto &[known, name] : names) {
    if (unit == known) return name;
  }
  return powers(unit);
}

}  // namespace scene
