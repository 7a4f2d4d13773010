// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether particles meet shapes other than spheres, decided without the library in rational numbers. The cell must not
// be tilted.
#pragma once

#include "oracle/rule.hpp"

namespace oracle {

// Whether an axis-aligned box is nearer to any image of the particle's centre than radius and margin reach, or holds
// it. Ends may be infinite.
bool box_meets(const hg_grid_def &def, const double *low, const double *high, const Sphere &particle);

}  // namespace oracle
