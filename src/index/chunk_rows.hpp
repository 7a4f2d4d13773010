// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The cells of all levels in a space that is mostly empty (space/chunk_table.hpp): layers of rows along x, rows of
// chunks of 8 cells, of which only those that hold particles are stored, sorted. Memory is O(N) whatever the extent.
#pragma once

#include "src/base/memory.hpp"
#include "src/exact/domain.hpp"
#include "src/exact/interaction.hpp"
#include "src/index/chunk_plane.hpp"
#include "src/kernels/kernel_set.hpp"
#include "src/particles/participants.hpp"
#include "src/space/chunk_table.hpp"
#include "src/space/fixed_point.hpp"
#include "src/space/shifts.hpp"

#include <cstddef>
#include <cstdint>

namespace hg {

// One level: its cells, and which of the layers are its own. Lengths are whole quanta that float holds exactly.
struct ChunkLevel {
  double cell = 0, row_width = 0;
  bool giants = false;  // distances as long as its particles are wide do not fit into coordinates
  double slack = 0;
  PlaceBox space;                        // that cells are laid over
  uint64_t first_layer = 0, layers = 0;  // numbers of layers are unique among levels, with one left out between two
  size_t first = 0, end = 0;             // layers that are stored

  double chunk_length() const { return kChunkCells * cell; }
  double corner_x(int32_t chunk_x) const { return space.low[0] + static_cast<double>(chunk_x) * chunk_length(); }
  double corner_y(uint32_t row_y) const { return space.low[1] + static_cast<double>(row_y) * row_width; }
  double corner_z(uint64_t layer) const { return space.low[2] + static_cast<double>(layer - first_layer) * row_width; }
};

// What building needs besides, kept between builds.
struct ChunkScratch {
  explicit ChunkScratch(Memory &memory)
      : points(memory),
        keys(memory),
        other_keys(memory),
        packed(memory),
        row_key(memory),
        plane{ChunkPlane(memory), ChunkPlane(memory)},
        place(memory),
        level_keys(memory),
        diameters(memory),
        any(memory) {}
  Buffer<Point> points;               // by slot
  Buffer<ChunkKey> keys, other_keys;  // and room to sort them; or
  Buffer<uint64_t> packed;            // both, if keys fit into one number
  Buffer<uint64_t> row_key;           // of each row
  ChunkPlane plane[2];                // a layer and the next one
  Buffer<uint32_t> place;             // there, of each chunk
  Buffer<ChunkLevelKey> level_keys;   // of each level, class by class
  Buffer<double> diameters;           // of each level
  Buffer<uint8_t> any;                // likewise: does it hold particles?
};

class ChunkRows {
 public:
  explicit ChunkRows(Memory &memory)
      : levels_(memory),
        layer_(memory),
        layer_row_(memory),
        row_y_(memory),
        row_chunk_(memory),
        chunk_x_(memory),
        chunk_cell_(memory),
        chunk_row_(memory),
        chunk_of_(memory),
        origin_x_(memory),
        origin_y_(memory),
        origin_z_(memory),
        word_{Buffer<int32_t>(memory), Buffer<int32_t>(memory), Buffer<int32_t>(memory), Buffer<int32_t>(memory),
              Buffer<int32_t>(memory)},
        cell_begin_(memory),
        giant_place_{Buffer<double>(memory), Buffer<double>(memory), Buffer<double>(memory)} {}

  // Beyond that many quanta particles are giants: 3 chunks of a level are 12 diameters long, and shall be below 2^30.
  static constexpr double kGiantDiameter = 0x1p26;
  // More particles than that have no place for their chunks in a word.
  static constexpr size_t kMostParticles = size_t{1} << 26;

  // Of the levels, all classes of the finest one first: the largest diameter (with margin) on each; and the largest
  // radius that an insertion level takes.
  struct Sizes {
    int insertion_levels = 0;
    double radius_limit[HG_MAX_LEVELS];
    const double *diameter = nullptr;
    ClassRanges classes;

    int level_count() const { return insertion_levels * classes.count; }
    int level_number(int insertion_level, int c) const { return insertion_level * classes.count + c; }
  };
  // Lays cells over the particles that `input` names (its levels and bits are set here), and sorts them: slot[i]
  // becomes the slot of particle i in sorted order. The scratch has the points then, by slot.
  void build(ChunkInput input, const Sizes &sizes, int dimension, uint32_t *slot, ChunkScratch &scratch, int threads);
  // Keeps the places of giants, which are the particles from `begin` on.
  void place_giants(const ChunkInput &input, const uint32_t *slot, uint32_t begin, size_t count, int dimension);

  const ChunkLevel &level(int h) const { return levels_[static_cast<size_t>(h)]; }
  ChunkTable table(int h, float largest_radius) const;
  size_t rows() const { return rows_; }
  size_t chunks() const { return chunks_; }
  size_t cells() const { return cells_; }

  // Chunks in the sorted order of their particles.
  uint32_t chunk_of(uint32_t particle) const { return chunk_of_[particle]; }
  uint32_t chunk_begin(size_t chunk) const { return cell_begin_[static_cast<size_t>(chunk_cell_[chunk])]; }
  uint32_t chunk_end(size_t chunk) const { return cell_begin_[static_cast<size_t>(chunk_cell_[chunk]) + kChunkCells]; }
  int32_t chunk_cell(size_t chunk) const { return chunk_cell_[chunk]; }
  // The coordinates of the lower corner.
  const int32_t *origin(int axis) const { return (axis == 0 ? origin_x_ : (axis == 1 ? origin_y_ : origin_z_)).data(); }

  // Calls visit(chunk, corner) for all chunks of the level that the box meets, and perhaps some that it nearly meets,
  // in sorted order; `corner` is the lower one, as a place. False from visit ends it.
  template <class Visit>
  bool visit_box(const ChunkLevel &level, const PlaceBox &box, Visit &&visit) const {
    const Window window = window_of(level, box);
    double corner[3];
    for (size_t layer = first_layer(level, window); layer < level.end && layer_[layer] <= window.last[2]; layer++) {
      corner[2] = level.corner_z(layer_[layer]);
      for (size_t row = first_row(layer, window); row < layer_row_[layer + 1] && row_y_[row] <= window.last_y();
           row++) {
        corner[1] = level.corner_y(row_y_[row]);
        for (size_t chunk = first_chunk(row, window); chunk < row_chunk_[row + 1]; chunk++) {
          if (chunk_x_[chunk] > window.last_x()) break;
          corner[0] = level.corner_x(chunk_x_[chunk]);
          if (!visit(chunk, corner)) return false;
        }
      }
    }
    return true;
  }
  double giant_place(int axis, uint32_t particle) const { return giant_place_[axis][particle - giant_begin_]; }
  bool has_giants() const { return giant_begin_ < giant_end_; }
  // The same of one chunk. O(log layers).
  void find_corner(const ChunkLevel &level, size_t chunk, double *corner) const;
  // The place of a particle, given its chunk and the corner of that.
  void find_place(const PointArrays &points, uint32_t particle, size_t chunk, const double *corner, int dimension,
                  double *place) const;

 private:
  // Numbers of chunks, rows and layers that a box meets.
  struct Window {
    uint64_t first[3], last[3];
    uint32_t first_y() const { return static_cast<uint32_t>(first[1]); }
    uint32_t last_y() const { return static_cast<uint32_t>(last[1]); }
    int32_t last_x() const { return static_cast<int32_t>(last[0]); }
  };
  Window window_of(const ChunkLevel &level, const PlaceBox &box) const;
  size_t first_layer(const ChunkLevel &level, const Window &window) const;
  size_t first_row(size_t layer, const Window &window) const;
  size_t first_chunk(size_t row, const Window &window) const;

  bool lay(const ChunkInput &input, const Sizes &sizes);
  void find_spaces(const ChunkInput &input, const Sizes &sizes, int dimension, ChunkScratch &scratch);
  void list_level_keys(const Sizes &sizes, ChunkScratch &scratch) const;
  const ChunkKey *sorted_keys(const ChunkInput &input, const Sizes &sizes, const ChunkBuildKernel &kernel,
                              ChunkScratch &scratch, int threads) const;
  const uint64_t *sorted_packed_keys(const ChunkInput &input, const Sizes &sizes, const ChunkBuildKernel &kernel,
                                     const PackedKeys &packed, ChunkScratch &scratch, int threads) const;
  template <class KeyAt>
  void list_chunks(KeyAt &&key_at, size_t count, uint32_t *slot, ChunkScratch &scratch);
  void list_layers(const ChunkScratch &scratch);
  void set_origins();
  uint32_t level_chunk_begin(const ChunkLevel &level) const { return row_chunk_[layer_row_[level.first]]; }
  uint32_t level_chunk_end(const ChunkLevel &level) const { return row_chunk_[layer_row_[level.end]]; }
  void link_rows(int dimension, ChunkScratch &scratch);
  void link_own_row();
  // A part of a layer that takes all chunks of a level, from chunk x of row y on.
  struct Places {
    int32_t x;
    uint32_t y;
    int64_t along, rows;
  };
  Places places_of(const ChunkLevel &level) const;
  void link_by_places(const ChunkLevel &level, const Places &places, int dimension, ChunkScratch &scratch);
  int32_t word_from(const ChunkPlane &plane, size_t place) const;
  void link_by_search(const ChunkLevel &level, int dimension, const ChunkScratch &scratch);
  void link_row(size_t row, int stencil_row, size_t neighbor);
  size_t lower_chunk(size_t row, int32_t x) const;

  ChunkLevel &level_at(int h) { return levels_[static_cast<size_t>(h)]; }

  Buffer<ChunkLevel> levels_;
  int level_count_ = 0;
  int cell_bits_ = 0, row_bits_ = 0, layer_bits_ = 0;
  size_t layers_ = 0, rows_ = 0, chunks_ = 0, cells_ = 0;

  Buffer<uint64_t> layer_;      // numbers
  Buffer<size_t> layer_row_;    // where the rows of each begin
  Buffer<uint32_t> row_y_;      // number in the layer
  Buffer<uint32_t> row_chunk_;  // where the chunks of each begin
  Buffer<int32_t> chunk_x_;     // number in the row
  Buffer<int32_t> chunk_cell_;  // the first, in cell_begin
  Buffer<uint32_t> chunk_row_;
  Buffer<uint32_t> chunk_of_;  // of each particle
  Buffer<int32_t> origin_x_, origin_y_, origin_z_;
  Buffer<int32_t> word_[kStencilRows];
  Buffer<uint32_t> cell_begin_;
  uint32_t giant_begin_ = 0, giant_end_ = 0;
  Buffer<double> giant_place_[3];
};

}  // namespace hg
