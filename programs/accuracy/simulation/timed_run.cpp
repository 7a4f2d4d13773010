// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/simulation/timed_run.hpp"

#include "programs/measure/statistics.hpp"
#include "programs/measure/timing.hpp"

namespace accuracy {

TimedRun::TimedRun(const dem::Setup &setup, dem::Precision precision, uint64_t warm_up, uint64_t steps)
    : engine_(dem::make_engine(setup, precision)), steps_(steps), particles_(static_cast<double>(setup.count())) {
  engine_->run(warm_up);
}

void TimedRun::run() {
  seconds_.push_back(measure::seconds_of([this] { engine_->run(steps_); }));
}

double TimedRun::ns_per_particle_and_step() const {
  return 1e9 * measure::median(seconds_) / (particles_ * static_cast<double>(steps_));
}

}  // namespace accuracy
