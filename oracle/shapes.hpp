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

// How a triangle in space ([3 corners][3]) and the nearest image of a particle are placed.
enum class Meeting {
  kNone,    // farther apart than radius, margin and `tolerance` reach
  kNearly,  // farther apart than radius and margin reach, but not by more than the tolerance
  kTouching,
  kMeeting
};
Meeting triangle_meeting(const hg_grid_def &def, const double *corners, const Sphere &particle, double tolerance);

}  // namespace oracle
