// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A packing without overlaps: radii from a size law, grown from random points by event-driven dynamics.
#pragma once

#include "packing/event/growth.hpp"
#include "packing/packing.hpp"

namespace packing::event {

struct GrownPacking {
  particles::ParticleSet particles;  // in random order
  GrowthResult growth;
};

// Checks the request (its sweeps do not count) and grows the packing at `rate`, 0 for the usual one. If the growth was
// stopped or jammed, the particles are smaller, but do not overlap either. The same request gives the same bytes on any
// machine. Throws particles::Error, also if the library finds an overlap in the end.
GrownPacking grow_packing(const Request &request, double rate, const GrowthObserver &observe);

}  // namespace packing::event
