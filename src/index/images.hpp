// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Periodic images: particles near a periodic face, moved by a box length, so that searches themselves know no periods.
#pragma once

#include "src/index/index.hpp"

namespace hg {

// Fills index.images and the image ranges of its levels. Nothing on open axes; on periodic ones O(particles near
// faces).
void build_images(Index &index);

}  // namespace hg
