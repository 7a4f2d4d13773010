// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The extents of a set of particles.
#pragma once

namespace hg {

struct Bounds {
  double min[3] = {0, 0, 0};  // of the centres' positions (Domain::position): 0 and the length on periodic axes
  double max[3] = {0, 0, 0};
  double width[3] = {0, 0, 0};  // of the space that the particles themselves take; of the box where one is given
  double max_radius = 0;
};

}  // namespace hg
