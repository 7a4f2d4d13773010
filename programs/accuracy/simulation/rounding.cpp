// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Varies the time step again, for a state in float and in double: the smaller the step, the more often it is rounded.
#include "dem/engine/time_step.hpp"
#include "programs/accuracy/simulation/elastic_gas.hpp"
#include "programs/accuracy/simulation/gas_energy.hpp"
#include "programs/accuracy/simulation/studies.hpp"
#include "programs/accuracy/simulation/timed_run.hpp"

namespace accuracy {
namespace {

constexpr size_t kTimedCount = 4096;
constexpr double kContactsTimed = 6;

// ns per particle and t_c.
double cost_of(const dem::Setup &setup, dem::Precision precision, double steps) {
  TimedRun timed(setup, precision, static_cast<uint64_t>(steps), static_cast<uint64_t>(kContactsTimed * steps));
  timed.run();
  return steps * timed.ns_per_particle_and_step();
}

}  // namespace

void measure_rounding(Recorder &record) {
  const bool quick = record.budget().quick;
  const std::vector<double> all = {10, 20, 50, 100, 200}, few = {20, 50};
  dem::Setup timed = melted_gas(timed_gas(kTimedCount));
  for (const dem::Precision precision : {dem::Precision::kDouble, dem::Precision::kFloat}) {
    const bool is_float = precision == dem::Precision::kFloat;
    record.begin(is_float ? "float" : "double");
    for (const double n : quick ? few : all) {
      EnergyCase what;
      what.gas.mass_spread = 0.3;
      what.steps = n;
      what.precision = precision;
      what.spans = quick ? 10 : 80;
      timed.time_step = dem::shortest_contact(timed) / n;
      record.add({"n = " + std::to_string(static_cast<int>(n)),
                  cost_of(timed, precision, n),
                  {{"energy change in 25 t_c", energy_errors(what).change, ""}},
                  !is_float && n == dem::kUsualStepsPerContact,
                  n});
    }
  }
}

}  // namespace accuracy
