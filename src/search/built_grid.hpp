// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a query reads of a grid that is built. A query is a function over this; several may run at the same time.
#pragma once

#include "src/exact/overlap.hpp"
#include "src/index/index.hpp"
#include "src/particles/particle_store.hpp"
#include "src/search/stored_candidates.hpp"

namespace hg {

struct BuiltGrid {
  const ParticleStore &store;
  const Overlap &overlap;
  const Index &index;
  const StoredCandidates &candidates;  // of that index; particles may have moved since within the skin
  int threads;

  // How many edges of the cell are taken off a particle of the index to where the search sees it.
  Shift boxes(uint32_t particle, uint32_t slot) const {
    return candidates.moved() ? candidates.boxes(particle, store) : index.domain.boxes(store.center(slot));
  }
};

}  // namespace hg
