// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Finds the particles that one sphere, not necessarily a particle, interacts with.
#pragma once

#include "src/exact/overlap.hpp"
#include "src/index/index.hpp"
#include "src/particles/particle_store.hpp"
#include "src/search/stored_candidates.hpp"

#include <cstdint>

namespace hg {

// Writes the slots of the particles met, each once, in no order, into `found` and returns their number. The index may
// be that of `candidates` which have moved since.
size_t search_sphere(const Index &index, const ParticleStore &store, const Overlap &overlap,
                     const StoredCandidates &candidates, const Ball &sphere, Buffer<int32_t> &found);

}  // namespace hg
