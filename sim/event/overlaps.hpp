// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// The proof of a packing: how many pairs overlap and how many particles cut a wall.
#ifndef HGRID_SIM_EVENT_OVERLAPS_HPP
#define HGRID_SIM_EVENT_OVERLAPS_HPP

#include "sim/box.hpp"
#include "sim/vector.hpp"

#include <cstddef>
#include <vector>

namespace hgrid_sim::event {

// The number of overlapping pairs, images included, decided by the library as real arithmetic on these doubles would,
// and of particles whose extent in doubles, x - r and x + r, passes a wall. Throws Error as the library does.
std::size_t count_overlaps(const Box &box, const std::vector<Vector> &centers, const std::vector<double> &radii);
std::size_t count_beyond_walls(const Box &box, const std::vector<Vector> &centers, const std::vector<double> &radii);

}  // namespace hgrid_sim::event

#endif
