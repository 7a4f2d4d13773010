// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a region holds and what flows through it.
#include "dem/engine/region_content.hpp"

#include "dem/base/vector.hpp"

#include <cmath>

namespace dem {

RegionContent content_of(const Region &region, const Snapshot &state) {
  RegionContent content;
  const auto dimension = static_cast<size_t>(state.dimension);
  double space = 1;
  for (size_t axis = 0; axis < dimension; axis++) space *= region.high[axis] - region.low[axis];
  for (size_t i = 0; i < state.count(); i++) {
    if (!region.holds(&state.centers[i * dimension], state.dimension)) continue;
    const double radius = state.radii[i], mass = state.masses[i];
    content.count++;
    content.fraction += volume_of_particle(radius, state.dimension) / space;
    if (!std::isfinite(mass)) continue;
    content.mass += mass;
    for (size_t axis = 0; axis < dimension; axis++) {
      content.flow[axis] += mass * state.velocities[i * dimension + axis] / (region.high[axis] - region.low[axis]);
    }
  }
  return content;
}

}  // namespace dem
