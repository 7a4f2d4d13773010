// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Errors that fall as a power of the steps per contact: error = factor n^-order.
#pragma once

#include "programs/measure/least_squares.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace accuracy {

struct PowerLaw {
  double order = 0, factor = 0;
  double at(double steps) const { return factor * std::pow(steps, -order); }
};

// The law nearest to the errors > 0 at these steps, by least squares of the logarithms. An error that does not fall has
// the order 0.
inline PowerLaw fit_power_law(const std::vector<double> &steps, const std::vector<double> &errors) {
  std::vector<measure::Observation<1>> observations;
  double mean_steps = 0, mean_error = 0;
  for (size_t k = 0; k < steps.size(); k++) {
    const double log_steps = std::log(steps[k]), log_error = std::log(errors[k]);
    observations.push_back({0, {-log_steps}, log_error, 1});
    mean_steps += log_steps / static_cast<double>(steps.size());
    mean_error += log_error / static_cast<double>(steps.size());
  }
  const double order = measure::fit_non_negative<1>(observations)[0];
  return {order, std::exp(mean_error + order * mean_steps)};
}

}  // namespace accuracy
