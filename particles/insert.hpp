// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A particle set into a grid of the library.
#pragma once

#include "particles/particle_set.hpp"

#include <hgrid/hgrid.hpp>

namespace particles {

inline void insert(const ParticleSet &set, hgrid::Grid &grid) {
  grid.insert(set.count(), set.centers.data(), set.radii.data());
}

}  // namespace particles
