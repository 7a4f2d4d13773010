// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// When the stored candidates of moving particles are searched anew: every k steps, or when the particles have moved.
#pragma once

#include "programs/accuracy/trade.hpp"
#include "programs/measure/step_timer.hpp"

#include <cstddef>
#include <vector>

namespace accuracy {

std::vector<TradePoint> measure_skins(const Budget &budget, const Progress &progress);

// What a list that is kept for `interval` steps misses in `steps` steps of a flight.
struct Missed {
  size_t contacts = 0, missed = 0;  // summed over the steps
  double deepest = 0;               // overlap over the smaller radius, of the missed
};
Missed missed_contacts(const particles::ParticleSet &start, double displacement, double margin, int interval,
                       int steps);

}  // namespace accuracy
