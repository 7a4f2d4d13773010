// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The knob of the time step again, for a state in float and in double: the smaller the step, the more often it is
// rounded.
#include "programs/accuracy/simulation/rounding_knob.hpp"

#include "dem/setup/time_step.hpp"
#include "programs/accuracy/simulation/elastic_gas.hpp"
#include "programs/accuracy/simulation/gas_energy.hpp"
#include "programs/accuracy/simulation/step_cost.hpp"

#include <string>

namespace accuracy {
namespace {

constexpr size_t kTimedCount = 4096;
constexpr double kContactsTimed = 6;

// ns per particle and t_c.
double cost_of(const dem::Setup &setup, dem::Precision precision, double steps) {
  TimedRun run(setup, precision, static_cast<uint64_t>(steps));
  run.run(static_cast<uint64_t>(kContactsTimed * steps));
  return steps * run.ns_per_particle_and_step();
}

}  // namespace

std::vector<TradePoint> measure_rounding(const Budget &budget, const Progress &progress) {
  dem::Setup timed = melted_gas(timed_gas(kTimedCount));
  std::vector<TradePoint> points;
  for (const dem::Precision precision : {dem::Precision::kDouble, dem::Precision::kFloat}) {
    const bool is_float = precision == dem::Precision::kFloat;
    const std::string system = is_float ? "float" : "double";
    progress(system);
    for (const double n : budget.quick ? std::vector<double>{20, 50} : std::vector<double>{10, 20, 50, 100, 200}) {
      EnergyCase what;
      what.gas.mass_spread = 0.3;
      what.steps = n;
      what.precision = precision;
      what.spans = budget.quick ? 10 : 80;
      timed.time_step = dem::shortest_contact(timed) / n;
      TradePoint point{"rounding",
                       system,
                       "n = " + std::to_string(static_cast<int>(n)),
                       "energy change in 25 t_c",
                       energy_errors(what).change,
                       cost_of(timed, precision, n),
                       !is_float && n == dem::kUsualStepsPerContact,
                       "",
                       n};
      points.push_back(point);
    }
  }
  return points;
}

}  // namespace accuracy
