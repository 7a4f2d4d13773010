// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a simulated time costs.
#include "programs/accuracy/simulation/step_cost.hpp"

#include "programs/measure/search_timer.hpp"

namespace accuracy {

TimedRun::TimedRun(const dem::Setup &setup, dem::Precision precision, uint64_t warm_up)
    : engine_(dem::make_engine(setup, precision)), particles_(static_cast<double>(setup.count())) {
  engine_->run(warm_up);
}

void TimedRun::run(uint64_t steps) {
  const double seconds = measure::seconds_of([&] { engine_->run(steps); });
  ns_.push_back(1e9 * seconds / (particles_ * static_cast<double>(steps)));
}

double TimedRun::ns_per_particle_and_step() const { return measure::median(ns_); }

}  // namespace accuracy
