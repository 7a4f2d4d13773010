// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The mapping phase (the paper's section 2.1): each particle goes to its level of insertion (Eq. 3) and to its cell
// there (Eqs. 1 and 2).
#pragma once

#include "src/index/index.hpp"
#include "src/kernels/kernel_set.hpp"
#include "src/particles/participants.hpp"

namespace hg {

// What the levels take, which stays while radii and levels do.
struct LevelPopulation {
  struct Level {
    uint32_t count;
    double largest_radius;  // up to this level
  };
  explicit LevelPopulation(Memory &memory) : levels(memory) {}
  bool counted = false;  // to be cleared when radii or groups have changed
  int level_count = 0;
  double radius_limit[HG_MAX_LEVELS];  // of each insertion level
  Buffer<Level> levels;                // of the index
};

// What building needs besides the index, kept between builds.
struct BuildScratch {
  explicit BuildScratch(Memory &memory)
      : tables(memory),
        level_rows(memory),
        row_of(memory),
        row_begin(memory),
        particles(memory),
        row(memory),
        chunks(memory),
        population(memory) {}
  struct Tables {
    size_t first_row, first_cell;
  };
  Buffer<Tables> tables;          // of each level
  Buffer<LevelRows> level_rows;   // likewise, class by class
  Buffer<uint32_t> row_of;        // of each particle, in slot order
  Buffer<uint32_t> row_begin;     // for each part of the particles
  Buffer<RowParticle> particles;  // row by row
  Buffer<uint32_t> row;           // for each worker, room to sort a row: a word per particle
  ChunkScratch chunks;
  LevelPopulation population;
};

// Sorts the particles into the levels of the plan, each class by itself. The index's interaction and, unless there are
// no particles, its map must be set. O(N) for dense levels.
void build_index(Index &index, BuildScratch &scratch, const Participants &particles, const LevelPlan &plan,
                 int threads);

}  // namespace hg
