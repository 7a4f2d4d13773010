// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Varies the integration scheme and its time step: the systems are the schemes, the settings steps per contact.

#include "programs/accuracy/simulation/elastic_gas.hpp"
#include "programs/accuracy/simulation/error_curves.hpp"
#include "programs/accuracy/simulation/studies.hpp"
#include "programs/accuracy/simulation/timed_run.hpp"

#include <algorithm>
#include <cmath>

namespace accuracy {
namespace {

using Steps = std::vector<double>;  // per contact

// Whole numbers, a quarter of an octave to half an octave apart; the usual 50 among them.
Steps collision_steps(bool quick) {
  return quick ? Steps{10, 20, 50, 160} : Steps{10, 14, 20, 28, 40, 50, 80, 112, 160, 224, 320};
}
Steps energy_steps(bool quick) { return quick ? Steps{20, 160} : Steps{10, 14, 20, 28, 50, 112}; }
constexpr int kSpans = 400, kQuickSpans = 40;  // of 25 t_c
constexpr int kMostRounds = 3;

std::vector<dem::Scheme> schemes() {
  return {dem::velocity_verlet(), dem::symplectic_euler(), dem::leapfrog(), dem::forest_ruth()};
}

struct SchemeRun {
  std::string scheme;
  Contacts contacts;
  double steps;  // per contact
  TimedRun gas;

  void run() { gas.run(); }
};

// The same gas with other contacts, about as stiff: at an overlap of 1 % of the radius Hertz's force is the spring's.
dem::Setup with_contacts(dem::Setup gas, Contacts contacts) {
  if (contacts == Contacts::kHertz) {
    constexpr double kRadius = 0.5, kOverlap = 0.01;  // reduced radius
    gas.effects |= dem::kHertz;
    gas.contact.young_modulus = 2 * 0.75 * gas.contact.stiffness / std::sqrt(kRadius * kOverlap);
    gas.impact_speed = 10;  // no two spheres of this gas meet as fast
  } else if (contacts == Contacts::kRough) {
    gas.effects |= dem::kFriction | dem::kDissipation;
    gas.contact.restitution = kRestitution;
    gas.contact.friction = 0.5;
  }
  return gas;
}

std::vector<SchemeRun> timed_runs(const Steps &steps, int rounds) {
  dem::Setup setup = melted_gas(timed_gas(kTimedGasCount));
  std::vector<SchemeRun> runs;
  for (const dem::Scheme &scheme : schemes()) {
    setup.scheme = scheme;
    for (const double n : steps) {
      runs.push_back({scheme.name, Contacts::kLinear, n, TimedRun(setup, dem::Precision::kDouble, n)});
    }
  }
  setup.scheme = dem::Setup().scheme;
  for (const Contacts contacts : {Contacts::kHertz, Contacts::kRough}) {
    const dem::Setup gas = with_contacts(setup, contacts);
    for (const double n : steps) {
      runs.push_back({gas.scheme.name, contacts, n, TimedRun(gas, dem::Precision::kDouble, n)});
    }
  }
  measure::in_turns(runs, rounds);
  return runs;
}

void add_curve(const std::string &scheme, const ErrorCurve &curve, const std::vector<SchemeRun> &runs,
               Recorder &record) {
  for (size_t k = 0; k < curve.steps.size(); k++) {
    const double n = std::floor(curve.steps[k] + 0.25);  // "any n" stands for n to n + 1
    const auto run = std::find_if(runs.begin(), runs.end(), [&](const SchemeRun &r) {
      return r.scheme == scheme && r.contacts == curve.contacts && r.steps == n;
    });
    record.add({"n = " + std::to_string(static_cast<int>(n)),
                run->gas.ns_per_contact(),
                {{curve.error_of, curve.errors[k], ""}},
                scheme == dem::Setup().scheme.name && n == dem::kUsualStepsPerContact,
                curve.steps[k]});
  }
}

}  // namespace

void measure_time_steps(Recorder &record) {
  const bool quick = record.budget().quick;
  const Steps for_collisions = collision_steps(quick), for_energy = energy_steps(quick);
  record.tell("timing");
  const std::vector<SchemeRun> runs =
      timed_runs(for_collisions, quick ? 1 : std::min(record.budget().repeats, kMostRounds));
  for (const dem::Scheme &scheme : schemes()) {
    record.begin(scheme.name, "collisions");
    for (const ErrorCurve &curve : collision_curves(scheme, for_collisions)) {
      add_curve(scheme.name, curve, runs, record);
    }
  }
  for (const dem::Scheme &scheme : schemes()) {
    record.begin(scheme.name, "energy of a gas");
    for (const ErrorCurve &curve : energy_curves(scheme, for_energy, quick ? kQuickSpans : kSpans)) {
      add_curve(scheme.name, curve, runs, record);
    }
  }
}

}  // namespace accuracy
