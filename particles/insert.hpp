// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A particle set into a grid of the library, and its box into the definition of one.
#pragma once

#include "particles/particle_set.hpp"

#include <hgrid/hgrid.hpp>

namespace particles {

// Dimension, box and periodic axes. Where the edge of an axis that is open leans over says nothing about images.
inline void set_box(const ParticleSet &set, hg_grid_def &def) {
  def.dimension = set.dimension;
  if (!set.has_box) return;
  for (int axis = 0; axis < set.dimension; axis++) {
    def.box_min[axis] = set.box_min[axis];
    def.box_max[axis] = set.box_max[axis];
    def.periodic[axis] = set.periodic[axis];
  }
  def.tilt[0] = def.periodic[1] != 0 ? set.tilt[0] : 0;
  for (const int k : {1, 2}) def.tilt[k] = def.periodic[2] != 0 ? set.tilt[k] : 0;
}

inline void insert(const ParticleSet &set, hgrid::Grid &grid) {
  grid.insert(set.count(), set.centers.data(), set.radii.data());
}

}  // namespace particles
