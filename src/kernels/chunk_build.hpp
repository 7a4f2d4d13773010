// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The two passes of building chunks (index/chunk_rows.hpp): a key of each of the caller's particles, by which they are
// sorted, and its point, and then the points in sorted order. Plain loops over blocks, as in build.hpp.
#pragma once

#include "src/kernels/choose_levels.hpp"
#include "src/kernels/kernel_set.hpp"
#include "src/kernels/wrap.hpp"

namespace hg {
namespace {

template <int D>
class ChunkBlock {
  static constexpr size_t kSize = 64;

 public:
  explicit ChunkBlock(const ChunkInput &input) : input_(input) {}

  static constexpr size_t size() { return kSize; }

  // Calls write(i, key) for each, and makes the points.
  template <class Write>
  void find_keys(size_t at, size_t count, Point *points, Write &&write) {
    load(at, count);
    to_places();
    make_points(count, points + at);
    choose_levels(radius_, input_.levels, input_.level_count, [this](size_t i, const ChunkLevelKey &level, bool yes) {
      take_if(yes, inverse_cell_[i], level.inverse_cell);
      take_if(yes, inverse_width_[i], level.inverse_width);
      take_if(yes, first_layer_[i], level.first_layer);
      for (int axis = 0; axis < D; axis++) take_if(yes, low_[axis][i], level.low[axis]);
    });
    uint64_t number[3][kSize];
    for (int axis = 0; axis < 3; axis++) {
      const double *inverse = axis == 0 ? inverse_cell_ : inverse_width_;
      for (size_t i = 0; i < kSize; i++) {
        number[axis][i] = axis < D ? floor_bits((position_[axis][i] - low_[axis][i]) * inverse[i]) : 0;
      }
    }
    const int row_bits = input_.row_bits;
    for (size_t i = 0; i < count; i++) {
      const uint64_t row = ((number[2][i] + first_layer_[i]) << row_bits) + number[1][i] + 1;
      write(at + i, ChunkKey{row, static_cast<uint32_t>(number[0][i]), static_cast<uint32_t>(at + i)});
    }
  }

 private:
  void load(size_t at, size_t count) {
    if (count == kSize) {
      for (size_t i = 0; i < kSize; i++) load_one(i, at + i);
    } else {
      for (size_t i = 0; i < kSize; i++) load_one(i, at + (i < count ? i : 0));
    }
  }

  void load_one(size_t i, size_t slot) {
    for (size_t axis = 0; axis < D; axis++) position_[axis][i] = input_.centers[slot * D + axis];
    radius_[i] = input_.radii[slot];
  }

  // Whole quanta above the origin, in doubles: FixedPoint::find_place on a block.
  void to_places() {
    wrap_from<D>(0, position_, input_.map, input_.extent);
    for (int axis = 0; axis < D; axis++) {
      const double scale = input_.map.scale, half_origin = input_.map.half_origin[axis];
      for (double &place : position_[axis]) place = to_whole(to_quanta(place, half_origin, scale));
    }
  }

  // Columns before points, so that the compiler makes vector code of both.
  void make_points(size_t count, Point *points) {
    for (int axis = 0; axis < D; axis++) {
      for (size_t i = 0; i < kSize; i++) coordinate_[axis][i] = low_word(position_[axis][i]);
    }
    alignas(64) double folded[kSize];
    for (size_t i = 0; i < kSize; i++) {
      const double here = (radius_[i] + input_.extra_radius) * input_.map.scale;
      folded[i] = here < kBeyondAnyExtent ? here : kBeyondAnyExtent;
    }
    for (size_t i = 0; i < kSize; i++) folded_[i] = static_cast<float>(folded[i]);
    for (size_t i = 0; i < count; i++) {
      points[i] = {coordinate_[0][i], coordinate_[1][i], D == 3 ? coordinate_[2][i] : 0, folded_[i]};
    }
  }

  // Of 0 <= x < 2^51.
  static uint64_t floor_bits(double x) {
    const double whole = to_whole(x);
    return whole_bits(whole) - (whole > x ? 1 : 0);  // of integers, as a branch would be taken every other time
  }

  const ChunkInput &input_;
  alignas(64) double position_[3][kSize];
  alignas(64) double radius_[kSize];
  alignas(64) int32_t coordinate_[3][kSize];
  alignas(64) float folded_[kSize];
  alignas(64) double inverse_cell_[kSize];
  alignas(64) double inverse_width_[kSize];
  alignas(64) uint64_t first_layer_[kSize];
  alignas(64) double low_[3][kSize];
};

template <int D, class Write>
void each_chunk_key(const ChunkInput &input, size_t begin, size_t end, Point *points, Write &&write) {
  ChunkBlock<D> block(input);
  for (size_t at = begin; at < end; at += block.size()) {
    block.find_keys(at, end - at < block.size() ? end - at : block.size(), points, write);
  }
}

template <int D>
void find_chunk_keys(const ChunkInput &input, size_t begin, size_t end, Point *points, ChunkKey *keys) {
  each_chunk_key<D>(input, begin, end, points, [keys](size_t i, const ChunkKey &key) { keys[i] = key; });
}

template <int D>
void find_packed_keys(const ChunkInput &input, const PackedKeys &packed, size_t begin, size_t end, Point *points,
                      uint64_t *keys) {
  each_chunk_key<D>(input, begin, end, points, [=](size_t i, const ChunkKey &key) { keys[i] = pack(packed, key); });
}

template <int D>
void put_into_chunks(const Point *points, const uint32_t *slots, size_t begin, size_t end, const PointColumns &output) {
  constexpr size_t kAhead = 64;
  for (size_t i = begin; i < end; i++) {
    if (i + kAhead < end) __builtin_prefetch(points + slots[i + kAhead]);
    const Point point = points[slots[i]];
    output.x[i] = point.x;
    output.y[i] = point.y;
    if constexpr (D == 3) output.z[i] = point.z;
    output.radius[i] = point.radius;
  }
}

template <int D>
constexpr ChunkBuildKernel make_chunk_build() {
  return {find_chunk_keys<D>, find_packed_keys<D>, put_into_chunks<D>};
}

}  // namespace
}  // namespace hg
