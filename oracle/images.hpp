// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which periodic images of a particle can be near another.
#pragma once

#include "oracle/rule.hpp"

#include <vector>

namespace oracle {

// All shifts of b whose image may be nearer to a than `distance` along each axis, in real arithmetic and in doubles,
// ascending; some are farther. Throws std::length_error if there are too many to look at.
std::vector<Shift> images_near(const hg_grid_def &def, const double *a, const double *b, double distance);

}  // namespace oracle
