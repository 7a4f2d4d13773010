// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The mapping phase in a space that is mostly empty: particles go to chunks of rows, on a scale of their own.
#pragma once

#include "src/index/index.hpp"
#include "src/particles/participants.hpp"

namespace hg {

// Sorts the particles of the store into chunks and sets the index's map. Its levels must have their plans, particles
// and largest radii.
void build_chunks(Index &index, ChunkScratch &scratch, const Participants &particles, int threads);

}  // namespace hg
