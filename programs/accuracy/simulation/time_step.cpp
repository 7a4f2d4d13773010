// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Varies the integration scheme and its time step: the systems are the schemes, the settings steps per contact.

#include "programs/accuracy/simulation/elastic_gas.hpp"
#include "programs/accuracy/simulation/error_curves.hpp"
#include "programs/accuracy/simulation/studies.hpp"
#include "programs/accuracy/simulation/timed_run.hpp"

#include <algorithm>

namespace accuracy {
namespace {

// Whole numbers, a quarter of an octave to half an octave apart; the usual 50 among them.
const std::vector<double> kCollisionSteps = {10, 14, 20, 28, 40, 50, 80, 112, 160, 224, 320};
const std::vector<double> kEnergySteps = {10, 14, 20, 28, 50, 112};
const std::vector<double> kQuickCollisionSteps = {10, 20, 50, 160};
const std::vector<double> kQuickEnergySteps = {20, 160};
constexpr int kSpans = 400, kQuickSpans = 40;  // of 25 t_c

constexpr int kMostRounds = 3;

const dem::Scheme kSchemes[] = {dem::velocity_verlet(), dem::symplectic_euler(), dem::leapfrog(), dem::forest_ruth()};

struct SchemeRun {
  std::string scheme;
  double steps;  // per contact
  TimedRun gas;

  void run() { gas.run(); }
};

std::vector<SchemeRun> timed_runs(const std::vector<double> &steps, int rounds) {
  dem::Setup setup = melted_gas(timed_gas(kTimedGasCount));
  std::vector<SchemeRun> runs;
  for (const dem::Scheme &scheme : kSchemes) {
    setup.scheme = scheme;
    for (const double n : steps) runs.push_back({scheme.name, n, TimedRun(setup, dem::Precision::kDouble, n)});
  }
  measure::in_turns(runs, rounds);
  return runs;
}

void add_curve(const std::string &scheme, const std::vector<double> &nominal_steps, const ErrorCurve &curve,
               const std::vector<SchemeRun> &runs, Recorder &record) {
  for (size_t k = 0; k < nominal_steps.size(); k++) {
    const double n = nominal_steps[k];
    const auto run =
        std::find_if(runs.begin(), runs.end(), [&](const SchemeRun &r) { return r.scheme == scheme && r.steps == n; });
    record.add({"n = " + std::to_string(static_cast<int>(n)),
                run->gas.ns_per_contact(),
                {{curve.error_of, curve.errors[k], ""}},
                scheme == dem::Setup().scheme.name && n == dem::kUsualStepsPerContact,
                curve.steps[k]});
  }
}

}  // namespace

void measure_time_steps(Recorder &record) {
  const Budget &budget = record.budget();
  const std::vector<double> &collision_steps = budget.quick ? kQuickCollisionSteps : kCollisionSteps;
  const std::vector<double> &energy_steps = budget.quick ? kQuickEnergySteps : kEnergySteps;
  record.tell("timing");
  const std::vector<SchemeRun> runs =
      timed_runs(collision_steps, budget.quick ? 1 : std::min(budget.repeats, kMostRounds));
  for (const dem::Scheme &scheme : kSchemes) {
    record.begin(scheme.name, "collisions");
    for (const ErrorCurve &curve : collision_curves(scheme, collision_steps)) {
      add_curve(scheme.name, collision_steps, curve, runs, record);
    }
  }
  for (const dem::Scheme &scheme : kSchemes) {
    record.begin(scheme.name, "energy of a gas");
    for (const ErrorCurve &curve : energy_curves(scheme, energy_steps, budget.quick ? kQuickSpans : kSpans)) {
      add_curve(scheme.name, energy_steps, curve, runs, record);
    }
  }
}

}  // namespace accuracy
