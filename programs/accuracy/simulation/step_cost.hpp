// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a simulated time costs.
#pragma once

#include "dem/engine/engine.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace accuracy {

// One simulation that is run and timed now and then.
class TimedRun {
 public:
  // Warms up by as many steps.
  TimedRun(const dem::Setup &setup, dem::Precision precision, uint64_t warm_up);

  void run(uint64_t steps);

  // The median of the runs so far.
  double ns_per_particle_and_step() const;

  dem::Engine &engine() { return *engine_; }

 private:
  std::unique_ptr<dem::Engine> engine_;
  double particles_;
  std::vector<double> ns_;
};

}  // namespace accuracy
