// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Finds all pairs of a built index: each level with itself, and each level with all finer ones. Every pair is met once.
#pragma once

#include "index.hpp"
#include "kernels/kernel.hpp"
#include "overlap.hpp"
#include "particle_store.hpp"

namespace hg {

// Sends all pairs, by slots plus sink.id_offset, to the sink. Returns when done or when the sink stops.
void search_pairs(const Index &index, const ParticleStore &store, const Overlap &overlap, PairSink &sink);

}  // namespace hg
