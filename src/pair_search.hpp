// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Finds all pairs of a built index: each level with itself, and each level with all finer ones. Every pair is met once.
#pragma once

#include "index.hpp"
#include "kernels/kernel.hpp"
#include "overlap.hpp"
#include "particle_store.hpp"

namespace hg {

// Makes a sink ready for searches of this index: it gets slots, plus the id of slot 0 if ids have no gaps.
void prepare_sink(PairSink &sink, const Index &index, const ParticleStore &store, const Overlap &overlap);

// Sends the pairs of one task to the sink. False if the sink stopped.
bool search_task(const SearchTask &task, const Index &index, const ParticleStore &store, PairSink &sink);

}  // namespace hg
