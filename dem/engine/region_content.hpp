// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a region holds and what flows through it.
#pragma once

#include "dem/engine/engine.hpp"
#include "dem/setup/region.hpp"

#include <cstddef>

namespace dem {

// Of the particles whose centres lie in the region; masses and flow of those that can move.
struct RegionContent {
  size_t count = 0;
  double mass = 0;
  double fraction = 0;  // their volume over that of the region
  // Mass per time through a cross-section of the region normal to each axis, towards its upper end: the mean over all
  // cross-sections, sum m v / edge.
  double flow[3]{};
};

RegionContent content_of(const Region &region, const Snapshot &state);

}  // namespace dem
