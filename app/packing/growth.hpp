// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// A packing without overlaps: radii from a size law, grown from random points by event-driven dynamics.
#ifndef APP_PACKING_GROWTH_HPP
#define APP_PACKING_GROWTH_HPP

#include "packing/packing.hpp"
#include "sim/event/growth.hpp"

#include <cstddef>

namespace packing {

struct GrownPacking {
  app::ParticleSet particles;  // in random order
  hgrid_sim::event::GrowthResult growth;
};

// Checks the request (its sweeps do not count) and grows the packing at `rate`, 0 for the usual one. If the growth was
// stopped or jammed, the particles are smaller, but do not overlap either. The same request gives the same bytes on any
// machine. Throws hgrid_sim::Error, and app::Error if the library finds an overlap in the end.
GrownPacking grow_packing(const Request &request, double rate, const hgrid_sim::event::GrowthObserver &observe);

}  // namespace packing

#endif
