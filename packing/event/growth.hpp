// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Packings without overlap: points that move, collide and grow until they fill the density asked for (Lubachevsky &
// Stillinger 1990).
#pragma once

#include "packing/box.hpp"
#include "packing/event/engine.hpp"
#include "packing/event/fluid.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace packing::event {

struct GrowthRequest {
  std::vector<double> radii;  // wanted; their volume over that of the box is the density wanted
  uint64_t seed = 1;
  // Growth of the scale, from 0 to 1, per time, at the end: the mean radius then grows at rate * <r> thermal speeds.
  // 0: the usual, 0.01 / <r>. It is faster at the start, where collisions are few.
  double rate = 0;
  int most_retries = 4;  // when jammed: each goes back and grows at a quarter of the rate
};

struct GrowthProgress {
  double density = 0;
  double share_done = 0;       // of the work, as estimated from the fluid's pressure
  double compressibility = 1;  // p V / (N kT), as measured last
  int retries = 0;
  const Tally *tally = nullptr;
};

// Told after every few thousand events; false stops the growth.
using GrowthObserver = std::function<bool(const GrowthProgress &)>;

enum class GrowthEnd { kDone, kStopped, kJammed };

struct GrowthResult {
  GrowthEnd end = GrowthEnd::kDone;
  std::vector<Vector> centers;
  std::vector<double> radii;  // those asked for, or all smaller by one factor if the end is not kDone; no overlaps
  double density = 0;
  double rate = 0;  // of the last try
  int retries = 0;
  double compressibility = 1;
  Tally tally;  // of all tries
};

// Places the particles at random and lets them grow. All have the same mass meanwhile: with masses as r^3 large
// particles would be slower than their own surfaces. Same request, same bytes.
// Throws Error if there are no particles, if they fill the box, or if a value is not allowed.
GrowthResult grow(const Box &box, const GrowthRequest &request, const GrowthObserver &observe = {});

}  // namespace packing::event
