// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The hierarchical grid itself: particles in fixed point, sorted by level, row and cell, with the tables that find
// them.
#pragma once

#include "src/base/memory.hpp"
#include "src/index/sparse_rows.hpp"
#include "src/kernels/kernel.hpp"
#include "src/levels/level_plan.hpp"
#include "src/particles/particle_store.hpp"
#include "src/space/bounds.hpp"
#include "src/space/frame.hpp"

#include <cstdint>

namespace hg {

// Fixed-point particles as structure of arrays.
class PointStore {
 public:
  explicit PointStore(Memory &memory) : x(memory), y(memory), z(memory), radius(memory), slot(memory), image(memory) {}
  PointArrays arrays(bool with_images) const {
    return {x.data(), y.data(), z.data(), radius.data(), slot.data(), with_images ? image.data() : nullptr};
  }
  // Room for `count` points and defined values in the padding; contents are lost.
  void require(size_t count, int dimension);

  Buffer<int32_t> x, y, z;
  Buffer<float> radius;
  Buffer<uint32_t> slot;
  Buffer<uint8_t> image;
};

struct IndexLevel {
  PlannedLevel plan;
  double largest_radius = 0;    // of the particles on the level
  double occupancy = 0;         // m_h
  uint32_t begin = 0, end = 0;  // in the sorted particles
  // Periodic images that reach into the box, in the sorted images: those that stand for a step forward come first, so
  // that own-level pairs across the box are met from one side only.
  uint32_t image_begin = 0, image_forward_end = 0, image_end = 0;
  bool sparse = false;
  CellTable cells{};   // unless sparse
  SparseLevel rows{};  // if sparse
};

// A piece of the search: points [begin, end), particles of `level` or its images, against `target`, a level not
// coarser.
struct SearchTask {
  int level, target;
  bool images;
  uint32_t begin, end;
};

// Read-only once built.
class Index {
 public:
  explicit Index(Memory &memory)
      : particles(memory), images(memory), sparse(memory), cell_begin(memory), tasks(memory) {}

  Interaction interaction;
  Domain domain;
  Frame frame;
  int level_count = 0;
  IndexLevel levels[HG_MAX_LEVELS];
  double largest_radius = 0;
  int64_t row_count = 0, cell_count = 0;

  PointStore particles;
  PointStore images;
  SparseRows sparse;
  Buffer<uint32_t> cell_begin;
  Buffer<SearchTask> tasks;  // all of the search, in the order of its pairs
  size_t task_count = 0;
};

// What building needs besides the index, kept between builds.
struct BuildScratch {
  explicit BuildScratch(Memory &memory) : row_of(memory), row_begin(memory), row(memory) {}
  Buffer<uint32_t> row_of;     // of each particle, in slot order
  Buffer<uint32_t> row_begin;  // for each part of the particles
  Buffer<uint32_t> row;        // for each worker, room to sort a row: 2 words per particle
};

// Sorts the particles of the store (which has no gaps) into the levels of the plan. O(N) for dense levels.
void build_index(Index &index, BuildScratch &scratch, const ParticleStore &store, const Bounds &bounds,
                 const LevelPlan &plan, int threads);

}  // namespace hg
