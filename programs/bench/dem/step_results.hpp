// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What steps cost, as a table for people and as CSV for plots.
#pragma once

#include "programs/bench/dem/step_rounds.hpp"

#include <string>
#include <vector>

namespace bench {

// What was measured on one system.
struct StepMeasurement {
  std::string sweep;  // "" or the name of the sweep that it belongs to
  std::string system;
  double size_ratio = 1;
  size_t particles = 0;
  double collisions = 0;  // per particle before the measurement
  std::vector<StepResult> results;
};

void print(const StepMeasurement &measurement);

// All measurements so far; the file is written anew.
void write_csv(const std::string &path, const std::vector<StepMeasurement> &measurements);

}  // namespace bench
