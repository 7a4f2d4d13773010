// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The hierarchical grid itself: particles in fixed point, sorted by level, row and cell, with the tables that find
// them.
#pragma once

#include "src/base/memory.hpp"
#include "src/exact/domain.hpp"
#include "src/exact/interaction.hpp"
#include "src/index/chunk_rows.hpp"
#include "src/index/squeezed_axes.hpp"
#include "src/kernels/points.hpp"
#include "src/levels/level_plan.hpp"
#include "src/particles/group_table.hpp"
#include "src/space/cell_table.hpp"
#include "src/space/fixed_point.hpp"
#include "src/space/shift_table.hpp"

#include <cstdint>

namespace hg {

// Fixed-point particles as structure of arrays.
class PointStore {
 public:
  explicit PointStore(Memory &memory)
      : x(memory), y(memory), z(memory), radius(memory), slot(memory), image(memory), body(memory) {}
  PointArrays arrays(bool with_images) const {
    return {x.data(),
            y.data(),
            z.data(),
            radius.data(),
            slot.data(),
            with_images ? image.data() : nullptr,
            with_bodies ? body.data() : nullptr};
  }
  PointColumns columns() { return {x.data(), y.data(), z.data(), radius.data(), slot.data()}; }
  Buffer<int32_t> &column(int axis) { return axis == 0 ? x : (axis == 1 ? y : z); }
  const Buffer<int32_t> &column(int axis) const { return axis == 0 ? x : (axis == 1 ? y : z); }
  // Room for `count` points and defined values in the padding; contents are lost.
  void require(size_t count, int dimension);

  Buffer<int32_t> x, y, z;
  Buffer<float> radius;
  Buffer<uint32_t> slot;
  Buffer<Image> image;
  bool with_bodies = false;
  Buffer<int32_t> body;
};

// The particles of one level of insertion and of one class of groups.
struct IndexLevel {
  PlannedLevel plan;
  int insertion_level = 0, group_class = 0;
  double largest_radius = 0;    // of the particles on the level
  uint32_t begin = 0, end = 0;  // in the sorted particles
  // Periodic images that reach into the box, in the sorted images: those that stand for a step forward come first, so
  // that own-level pairs across the box are met from one side only. Others are for other levels that it searches.
  uint32_t image_begin = 0, image_forward_end = 0, image_end = 0;
  CellTable cells{};  // unless the index is chunked

  bool is_empty() const { return begin == end; }
};

// Read-only once built.
class Index {
 public:
  Index(Memory &memory, const Domain &of_domain, const Interaction &of_interaction)
      : domain(of_domain),
        interaction(of_interaction),
        level_room(memory),
        shifts(memory),
        particles(memory),
        images(memory),
        cell_begin(memory),
        chunks(memory),
        squeezed(memory),
        image_place{Buffer<double>(memory), Buffer<double>(memory), Buffer<double>(memory)} {}

  // Lays out levels without particles, all classes of the finest one first.
  void lay_levels(const LevelPlan &plan, const GroupClasses &of_groups);
  int level_number(int insertion_level, int group_class) const { return insertion_level * classes.count + group_class; }
  // Does level h look for the particles of level k? Of two that meet, one does: the coarser one, or that of fewer.
  bool searches(int h, int k) const;

  uint32_t image_count() const { return level_count > 0 ? levels[level_count - 1].image_end : 0; }
  ChunkTable chunk_table(int h) const { return chunks.table(h, levels[h].cells.largest_radius); }
  bool is_squeezed(int axis) const { return squeezed.in_use() && !domain.periodic[axis]; }
  // Farther than any two of its particles interact.
  double largest_reach() const { return interaction.diameter(largest_radius); }
  // The cell is another one from now on; particles and cells stay where they are.
  void set_cell(const Domain &next) {
    for (int axis = 0; axis < 3; axis++) {
      domain.length[axis] = next.length[axis];
      domain.tilt[axis] = next.tilt[axis];
    }
    map.set_cell(domain);
    if (image_count() > 0) shifts.set_cell(domain, map);
  }

  Domain domain;
  Interaction interaction;  // that it is made for: the grid's, or wider by a skin
  FixedPoint map;
  int insertion_levels = 0;
  GroupClasses classes;
  int level_count = 0;           // in all classes
  IndexLevel *levels = nullptr;  // coarser ones behind finer ones
  Buffer<IndexLevel> level_room;
  size_t particle_count = 0;
  double largest_radius = 0;
  int64_t row_count = 0, cell_count = 0;

  ShiftTable shifts;  // of the images
  PointStore particles;
  PointStore images;
  Buffer<uint32_t> cell_begin;

  // In a space that is mostly empty levels are chunks of rows instead of tables of cells, and coordinates wrap.
  bool chunked = false;
  ChunkRows chunks;
  SqueezedAxes squeezed;
  Buffer<double> image_place[3];  // of each image, as FixedPoint::quanta counts
};

}  // namespace hg
