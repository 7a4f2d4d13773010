// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Periodic images: particles that whole edges of the periodic cell move near the box, so that searches themselves know
// no periods.
#pragma once

#include "src/index/index.hpp"

namespace hg {

// Fills index.shifts, index.images and the image ranges of its levels. Nothing on open axes; on periodic ones
// O(particles near faces), and as many images as come near the box.
void build_images(Index &index);

}  // namespace hg
