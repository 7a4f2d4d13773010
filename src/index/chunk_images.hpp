// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Periodic images of particles that are sorted into chunks of rows. Most chunks are far from all faces, and are not
// looked into; images of one chunk by one step lie together, so that they search together.
#pragma once

#include "src/index/index.hpp"

namespace hg {

// Appends the images of level h whose step is forward (lexicographically positive) or backward to the `at` images there
// are, and returns how many there are then.
uint32_t add_chunk_images(Index &index, int h, bool forward, uint32_t at);

}  // namespace hg
