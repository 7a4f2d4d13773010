// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Varies the time step again, for a state in float and in double: the smaller the step, the more often it is rounded.
#include "programs/accuracy/simulation/elastic_gas.hpp"
#include "programs/accuracy/simulation/gas_energy.hpp"
#include "programs/accuracy/simulation/studies.hpp"
#include "programs/accuracy/simulation/timed_run.hpp"

namespace accuracy {

void measure_rounding(Recorder &record) {
  const bool quick = record.budget().quick;
  const std::vector<double> all = {10, 20, 50, 100, 200}, few = {20, 50};
  const dem::Setup gas = melted_gas(timed_gas(kTimedGasCount));
  for (const dem::Precision precision : {dem::Precision::kDouble, dem::Precision::kFloat}) {
    const bool is_float = precision == dem::Precision::kFloat;
    record.begin(is_float ? "float" : "double");
    for (const double n : quick ? few : all) {
      EnergyCase what;
      what.gas.mass_spread = 0.3;
      what.steps = n;
      what.precision = precision;
      what.spans = quick ? 10 : 80;
      TimedRun timed(gas, precision, n);
      timed.run();
      record.add({"n = " + std::to_string(static_cast<int>(n)),
                  timed.ns_per_contact(),
                  {{"energy change in 25 t_c", energy_errors(what).change, ""}},
                  !is_float && n == dem::kUsualStepsPerContact,
                  n});
    }
  }
}

}  // namespace accuracy
