// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a list of candidates misses that is kept for too long.
#pragma once

#include "particles/particle_set.hpp"

#include <cstddef>

namespace accuracy {

struct Missed {
  size_t contacts = 0, missed = 0;  // summed over the steps
  double deepest = 0;               // overlap over the smaller radius, of the missed
};

// What a list that is kept for `interval` steps misses in `steps` steps of a flight.
Missed missed_contacts(const particles::ParticleSet &start, double displacement, double margin, int interval,
                       int steps);

}  // namespace accuracy
