// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/simulation/error_curves.hpp"

#include "programs/accuracy/simulation/collision_laws.hpp"
#include "programs/accuracy/simulation/gas_energy.hpp"
#include "programs/accuracy/simulation/oblique_impact.hpp"
#include "programs/accuracy/simulation/single_collision.hpp"

#include <cstddef>

namespace accuracy {
namespace {

struct Quantity {
  const char *name;
  bool whole_steps;
  double restitution;
  Deviation CollisionErrors::*error;
  PowerLaw (*law)(const dem::Scheme &scheme);
  bool hertz = false;
};

PowerLaw of_order_5_2(const dem::Scheme &) { return {2.5, 0}; }
PowerLaw of_order_2(const dem::Scheme &) { return {2, 0}; }
PowerLaw of_order_1(const dem::Scheme &) { return {1, 0}; }
PowerLaw of_order_5_4(const dem::Scheme &) { return {1.25, 0}; }

constexpr Quantity kQuantities[] = {
    {"duration", true, 1, &CollisionErrors::duration, elastic_duration_law},
    {"restitution, whole n", true, 1, &CollisionErrors::restitution, elastic_restitution_law},
    {"restitution, any n", false, 1, &CollisionErrors::restitution, any_step_restitution_law},
    {"largest overlap, any n", false, 1, &CollisionErrors::overlap, any_step_overlap_law},
    {"duration, damped", true, kDampedRestitution, &CollisionErrors::duration,
     [](const dem::Scheme &) { return damped_duration_law(kDampedRestitution); }},
    {"restitution, damped", true, kDampedRestitution, &CollisionErrors::restitution,
     [](const dem::Scheme &) { return damped_restitution_law(kDampedRestitution); }},
    {"largest overlap, damped", true, kDampedRestitution, &CollisionErrors::overlap,
     [](const dem::Scheme &) { return damped_overlap_law(kDampedRestitution); }},
    // The force of Hertz contacts grows from nothing as d^1.5: what a step misses of the onset is energy ~ (v dt)^2.5.
    // That of its dashpot grows as d^0.25: an impulse ~ dt (v dt)^0.25 is missed. The velocity of half a step before is
    // of order 1 with a factor so small, a Lambda^2 / 2, that it shows at far larger n only.
    {"duration, Hertz", false, 1, &CollisionErrors::duration, of_order_2, true},
    {"restitution, Hertz", false, 1, &CollisionErrors::restitution, of_order_5_2, true},
    {"largest overlap, Hertz", false, 1, &CollisionErrors::overlap, of_order_2, true},
    {"restitution, Hertz damped", false, kRestitution, &CollisionErrors::restitution, of_order_5_4, true}};

// The engine leaves room for faster approaches than the first, so it refuses the fewest steps.
constexpr double kFewestHertzSteps = 11;

constexpr char kSlip[] = "slip, friction";

constexpr char kEnergyChange[] = "energy change in 25 t_c";

EnergyCase energy_case(const dem::Scheme &scheme) {
  EnergyCase what;
  what.gas.mass_spread = 0.3;
  what.contacts_per_span = 25;
  what.scheme = scheme;
  return what;
}

bool is_usual(const dem::Scheme &scheme) { return scheme.name == dem::Setup().scheme.name; }

// The engine refuses dashpots with schemes that go back in time.
bool applies(const Quantity &quantity, const dem::Scheme &scheme) {
  if (quantity.hertz) return is_usual(scheme);
  return quantity.restitution == 1 || scheme.stages.size() == 1;
}

ErrorCurve slip_curve(const std::vector<double> &steps) {
  ErrorCurve curve{kSlip, steps, {}, Contacts::kRough};
  for (const double n : steps) {
    RoughCase what;
    what.steps = n;
    what.restitution = kRestitution;
    curve.errors.push_back(slip_error(what));
  }
  return curve;
}

}  // namespace

std::vector<ErrorCurve> collision_curves(const dem::Scheme &scheme, const std::vector<double> &steps) {
  std::vector<ErrorCurve> curves;
  for (const Quantity &quantity : kQuantities) {
    if (!applies(quantity, scheme)) continue;
    ErrorCurve curve{quantity.name, {}, {}, quantity.hertz ? Contacts::kHertz : Contacts::kLinear};
    for (const double n : steps) {
      if (quantity.hertz && n < kFewestHertzSteps) continue;
      CollisionCase what;
      what.scheme = scheme;
      what.steps = n;
      what.whole_steps = quantity.whole_steps;
      what.restitution = quantity.restitution;
      what.hertz = quantity.hertz;
      const CollisionErrors errors = collide(what);
      curve.steps.push_back(errors.steps);
      curve.errors.push_back((errors.*quantity.error).rms);
    }
    curves.push_back(curve);
  }
  if (is_usual(scheme)) curves.push_back(slip_curve(steps));
  return curves;
}

std::vector<ErrorCurve> energy_curves(const dem::Scheme &scheme, const std::vector<double> &steps, int spans) {
  EnergyCase what = energy_case(scheme);
  what.spans = spans;
  const auto total = static_cast<int>(what.contacts_per_span * spans);
  ErrorCurve change{kEnergyChange, steps, {}, Contacts::kLinear};
  ErrorCurve drift{"largest energy error in " + std::to_string(total) + " t_c", steps, {}, Contacts::kLinear};
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
  if (error_of == kSlip) return of_order_1(scheme);
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
