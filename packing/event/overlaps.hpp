// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The proof of a packing: how many pairs overlap and how many particles cut a wall.
#pragma once

#include "packing/box.hpp"
#include "packing/vector.hpp"

#include <cstddef>
#include <vector>

namespace packing::event {

// The number of overlapping pairs, images included, decided by the library as real arithmetic on these doubles would,
// and of particles whose extent in doubles, x - r and x + r, passes a wall. Throws Error as the library does.
size_t count_overlaps(const Box &box, const std::vector<Vector> &centers, const std::vector<double> &radii);
size_t count_beyond_walls(const Box &box, const std::vector<Vector> &centers, const std::vector<double> &radii);

}  // namespace packing::event
