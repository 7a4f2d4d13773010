// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A state in float against the same in double, after both have gone on from the same particles.
#pragma once

#include "dem/engine/engine.hpp"

#include <cstddef>

namespace accuracy {

struct StateErrors {
  size_t pairs = 0;            // that overlap in double
  size_t missed = 0;           // of them not in float
  size_t extra = 0;            // in float only
  double overlap = 0;          // rms error of the overlaps of common pairs over their rms
  double largest_overlap = 0;  // relative error
  double energy = 0;           // relative error
};

// Compares engines that stand at the same time. `setup` is what they were made from.
StateErrors compare_states(const dem::Setup &setup, dem::Engine &in_double, dem::Engine &in_float);

}  // namespace accuracy
