// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a simulated time costs.
#pragma once

#include "dem/engine/engine.hpp"
#include "dem/setup/time_step.hpp"
#include "programs/measure/statistics.hpp"
#include "programs/measure/timing.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace accuracy {

// One simulation that goes on and is timed, with so many time steps per contact.
class TimedRun {
 public:
  // Warms up by `warm_up` t_c; each run then takes `contacts` t_c.
  TimedRun(dem::Setup setup, dem::Precision precision, double steps_per_contact, int contacts = 6, int warm_up = 1)
      : particles_(static_cast<double>(setup.count())),
        steps_per_contact_(steps_per_contact),
        steps_(static_cast<uint64_t>(contacts * steps_per_contact)) {
    setup.time_step = dem::shortest_contact(setup).duration / steps_per_contact;
    engine_ = dem::make_engine(setup, precision);
    engine_->run(static_cast<uint64_t>(warm_up * steps_per_contact));
  }

  void run() {
    seconds_.push_back(measure::seconds_of([this] { engine_->run(steps_); }));
  }

  // ns per particle, by the median of the runs so far.
  double ns_per_step() const { return 1e9 * measure::median(seconds_) / (particles_ * static_cast<double>(steps_)); }
  double ns_per_contact() const { return steps_per_contact_ * ns_per_step(); }

  uint64_t steps_timed() const { return seconds_.size() * steps_; }
  dem::Engine &engine() { return *engine_; }

 private:
  std::unique_ptr<dem::Engine> engine_;
  double particles_, steps_per_contact_;
  uint64_t steps_;
  std::vector<double> seconds_;
};

}  // namespace accuracy
