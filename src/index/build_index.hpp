// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The mapping phase (the paper's section 2.1): each particle goes to its level of insertion (Eq. 3) and to its cell
// there (Eqs. 1 and 2).
#pragma once

#include "src/index/index.hpp"
#include "src/kernels/kernel_set.hpp"
#include "src/particles/particle_store.hpp"

namespace hg {

// What the levels take, which stays while radii and levels do.
struct LevelPopulation {
  bool counted = false;  // to be cleared when radii have changed
  int level_count = 0;
  double radius_limit[HG_MAX_LEVELS];
  uint32_t end[HG_MAX_LEVELS];           // how many particles this level and all finer ones take
  double largest_radius[HG_MAX_LEVELS];  // of the particles up to this level
};

// What building needs besides the index, kept between builds.
struct BuildScratch {
  explicit BuildScratch(Memory &memory)
      : row_of(memory), row_begin(memory), particles(memory), row(memory), chunks(memory) {}
  Buffer<uint32_t> row_of;        // of each particle, in slot order
  Buffer<uint32_t> row_begin;     // for each part of the particles
  Buffer<RowParticle> particles;  // row by row
  Buffer<uint32_t> row;           // for each worker, room to sort a row: a word per particle
  ChunkScratch chunks;
  LevelPopulation population;
};

// Sorts the particles of the store (which has no gaps) into the levels of the plan. The index's interaction and, unless
// there are no particles, its map must be set. O(N) for dense levels.
void build_index(Index &index, BuildScratch &scratch, const ParticleStore &store, const LevelPlan &plan, int threads);

}  // namespace hg
