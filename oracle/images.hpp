// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which periodic images of a particle can be near another.
#pragma once

#include "oracle/rule.hpp"

#include <vector>

namespace oracle {

bool is_tilted(const hg_grid_def &def);

// An image of b that is no farther from a than half an edge along each axis, but for rounding.
Shift middle_image(const hg_grid_def &def, const double *a, const double *b);

// All shifts of b whose image may be nearer to a than `distance` along each axis, in real arithmetic and in doubles,
// ascending; some are farther. Without a tilt and with HG_NEAREST_IMAGE only those that may be the nearest along each
// axis. Throws std::length_error if there are too many to look at.
std::vector<Shift> images_near(const hg_grid_def &def, const double *a, const double *b, double distance);

}  // namespace oracle
