// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The knob of the integration scheme and its time step: the systems are the schemes, the settings steps per contact.
#include "programs/accuracy/simulation/step_knob.hpp"

#include "dem/setup/time_step.hpp"
#include "programs/accuracy/simulation/elastic_gas.hpp"
#include "programs/accuracy/simulation/step_cost.hpp"
#include "programs/accuracy/simulation/step_errors.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace accuracy {
namespace {

// Whole numbers, a quarter of an octave to half an octave apart; the usual 50 among them.
const std::vector<double> kCollisionSteps = {10, 14, 20, 28, 40, 50, 80, 112, 160, 224, 320};
const std::vector<double> kEnergySteps = {10, 14, 20, 28, 50, 112};
const std::vector<double> kQuickCollisionSteps = {10, 20, 50, 160};
const std::vector<double> kQuickEnergySteps = {20, 160};
constexpr int kSpans = 400, kQuickSpans = 40;  // of 25 t_c

// Costs are those of a gas large enough to forget the work per step, and timed over the same span of simulated time
// with any time step: stored candidates then are searched anew as often.
constexpr size_t kTimedCount = 4096;
constexpr double kTimedContacts = 6;  // in t_c: two new searches
constexpr int kMostRounds = 3;

const dem::Scheme kSchemes[] = {dem::velocity_verlet(), dem::symplectic_euler(), dem::leapfrog(), dem::forest_ruth()};

struct Cost {
  std::string scheme;
  double steps, ns;  // per particle and t_c
};

std::vector<Cost> costs_of(const std::vector<double> &steps, int rounds) {
  dem::Setup setup = melted_gas(timed_gas(kTimedCount));
  std::vector<Cost> costs;
  std::vector<std::unique_ptr<TimedRun>> runs;
  for (const dem::Scheme &scheme : kSchemes) {
    for (const double n : steps) {
      setup.scheme = scheme;
      setup.time_step = dem::shortest_contact(setup) / n;
      costs.push_back({scheme.name, n, 0});
      runs.push_back(std::make_unique<TimedRun>(setup, dem::Precision::kDouble, static_cast<uint64_t>(n)));
    }
  }
  for (int round = 0; round < rounds; round++) {
    for (size_t k = 0; k < runs.size(); k++) {
      runs[k]->run(static_cast<uint64_t>(kTimedContacts * costs[k].steps));
    }
  }
  for (size_t k = 0; k < runs.size(); k++) costs[k].ns = costs[k].steps * runs[k]->ns_per_particle_and_step();
  return costs;
}

void add_points(const std::string &scheme, const std::vector<double> &nominal_steps, const ErrorCurve &curve,
                const std::vector<Cost> &costs, std::vector<TradePoint> &points) {
  for (size_t k = 0; k < nominal_steps.size(); k++) {
    const double n = nominal_steps[k];
    const auto cost =
        std::find_if(costs.begin(), costs.end(), [&](const Cost &c) { return c.scheme == scheme && c.steps == n; });
    TradePoint point;
    point.knob = "step";
    point.system = scheme;
    point.setting = "n = " + std::to_string(static_cast<int>(n));
    point.error_of = curve.error_of;
    point.error = curve.errors[k];
    point.cost = cost->ns;
    point.is_default = scheme == dem::Setup().scheme.name && n == dem::kUsualStepsPerContact;
    point.number = curve.steps[k];
    points.push_back(point);
  }
}

}  // namespace

std::vector<TradePoint> measure_steps(const Budget &budget, const Progress &progress) {
  const std::vector<double> &collision_steps = budget.quick ? kQuickCollisionSteps : kCollisionSteps;
  const std::vector<double> &energy_steps = budget.quick ? kQuickEnergySteps : kEnergySteps;
  progress("timing");
  const std::vector<Cost> costs = costs_of(collision_steps, budget.quick ? 1 : std::min(budget.repeats, kMostRounds));
  std::vector<TradePoint> points;
  for (const dem::Scheme &scheme : kSchemes) {
    progress(scheme.name + ", collisions");
    for (const ErrorCurve &curve : collision_curves(scheme, collision_steps)) {
      add_points(scheme.name, collision_steps, curve, costs, points);
    }
  }
  for (const dem::Scheme &scheme : kSchemes) {
    progress(scheme.name + ", energy of a gas");
    for (const ErrorCurve &curve : energy_curves(scheme, energy_steps, budget.quick ? kQuickSpans : kSpans)) {
      add_points(scheme.name, energy_steps, curve, costs, points);
    }
  }
  return points;
}

}  // namespace accuracy
