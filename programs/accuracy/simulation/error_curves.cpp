// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/simulation/error_curves.hpp"

#include "programs/accuracy/simulation/collision_laws.hpp"
#include "programs/accuracy/simulation/gas_energy.hpp"
#include "programs/accuracy/simulation/single_collision.hpp"

#include <cstddef>

namespace accuracy {
namespace {

struct Quantity {
  const char *name;
  bool whole_steps, damped;
  Deviation CollisionErrors::*error;
  PowerLaw (*law)(const dem::Scheme &scheme);
};

constexpr Quantity kQuantities[] = {
    {"duration", true, false, &CollisionErrors::duration, elastic_duration_law},
    {"restitution, whole n", true, false, &CollisionErrors::restitution, elastic_restitution_law},
    {"restitution, any n", false, false, &CollisionErrors::restitution, any_step_restitution_law},
    {"largest overlap, any n", false, false, &CollisionErrors::overlap, any_step_overlap_law},
    {"duration, damped", true, true, &CollisionErrors::duration,
     [](const dem::Scheme &) { return damped_duration_law(kDampedRestitution); }},
    {"restitution, damped", true, true, &CollisionErrors::restitution,
     [](const dem::Scheme &) { return damped_restitution_law(kDampedRestitution); }},
    {"largest overlap, damped", true, true, &CollisionErrors::overlap,
     [](const dem::Scheme &) { return damped_overlap_law(kDampedRestitution); }}};

constexpr char kEnergyChange[] = "energy change in 25 t_c";

EnergyCase energy_case(const dem::Scheme &scheme) {
  EnergyCase what;
  what.gas.mass_spread = 0.3;
  what.contacts_per_span = 25;
  what.scheme = scheme;
  return what;
}

// The engine refuses dashpots with schemes that go back in time.
bool applies(const Quantity &quantity, const dem::Scheme &scheme) {
  return !quantity.damped || scheme.stages.size() == 1;
}

}  // namespace

std::vector<ErrorCurve> collision_curves(const dem::Scheme &scheme, const std::vector<double> &steps) {
  std::vector<ErrorCurve> curves;
  for (const Quantity &quantity : kQuantities) {
    if (!applies(quantity, scheme)) continue;
    ErrorCurve curve{quantity.name, {}, {}};
    for (const double n : steps) {
      CollisionCase what;
      what.scheme = scheme;
      what.steps = n;
      what.whole_steps = quantity.whole_steps;
      what.restitution = quantity.damped ? kDampedRestitution : 1;
      const CollisionErrors errors = collide(what);
      curve.steps.push_back(errors.steps);
      curve.errors.push_back((errors.*quantity.error).rms);
    }
    curves.push_back(curve);
  }
  return curves;
}

std::vector<ErrorCurve> energy_curves(const dem::Scheme &scheme, const std::vector<double> &steps, int spans) {
  EnergyCase what = energy_case(scheme);
  what.spans = spans;
  const auto total = static_cast<int>(what.contacts_per_span * spans);
  ErrorCurve change{kEnergyChange, steps, {}};
  ErrorCurve drift{"largest energy error in " + std::to_string(total) + " t_c", steps, {}};
  for (const double n : steps) {
    what.steps = n;
    const EnergyErrors errors = energy_errors(what);
    change.errors.push_back(errors.change);
    drift.errors.push_back(errors.largest);
  }
  return {change, drift};
}

PowerLaw expected_law(const dem::Scheme &scheme, const std::string &error_of) {
  for (const Quantity &quantity : kQuantities) {
    if (error_of == quantity.name) return quantity.law(scheme);
  }
  return error_of == kEnergyChange ? energy_change_law(energy_case(scheme)) : PowerLaw{};
}

PowerLaw fitted_law(const std::vector<double> &steps, const std::vector<double> &errors) {
  std::vector<double> some_steps, some_errors;
  for (size_t k = 0; k < steps.size(); k++) {
    if (steps[k] < kFittedFrom) continue;
    some_steps.push_back(steps[k]);
    some_errors.push_back(errors[k]);
  }
  return fit_power_law(some_steps, some_errors);
}

}  // namespace accuracy
