// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a simulated time costs.
#pragma once

#include "dem/engine/engine.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace accuracy {

// One simulation that goes on and is timed.
class TimedRun {
 public:
  // Warms up by `warm_up` steps; each run then takes `steps`.
  TimedRun(const dem::Setup &setup, dem::Precision precision, uint64_t warm_up, uint64_t steps);

  void run();

  // The median of the runs so far.
  double ns_per_particle_and_step() const;

  dem::Engine &engine() { return *engine_; }

 private:
  std::unique_ptr<dem::Engine> engine_;
  uint64_t steps_;
  double particles_;
  std::vector<double> seconds_;
};

}  // namespace accuracy
