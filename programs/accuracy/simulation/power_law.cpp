// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Errors that fall as a power of the steps per contact.
#include "programs/accuracy/simulation/power_law.hpp"

#include "programs/measure/least_squares.hpp"

#include <cmath>
#include <cstddef>

namespace accuracy {

double PowerLaw::at(double steps) const { return factor * std::pow(steps, -order); }

PowerLaw fit_power_law(const std::vector<double> &steps, const std::vector<double> &errors) {
  std::vector<measure::Observation<1>> observations;
  double mean_steps = 0, mean_error = 0;
  for (size_t k = 0; k < steps.size(); k++) {
    const double log_steps = std::log(steps[k]), log_error = std::log(errors[k]);
    observations.push_back({0, {-log_steps}, log_error, 1});
    mean_steps += log_steps / static_cast<double>(steps.size());
    mean_error += log_error / static_cast<double>(steps.size());
  }
  PowerLaw law;
  law.order = measure::fit_non_negative<1>(observations)[0];
  law.factor = std::exp(mean_error + law.order * mean_steps);
  return law;
}

}  // namespace accuracy
