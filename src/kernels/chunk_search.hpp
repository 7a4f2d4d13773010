// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The contact detection where levels are chunks of rows (space/chunk_table.hpp): the same two steps as in search.hpp.
// Positions are seen from the corner of a chunk, so that floats are as fine in a space of any extent; which rows are
// neighbours is known from building, so that no row is looked for.
#pragma once

#include "src/kernels/range_test.hpp"
#include "src/space/chunk_table.hpp"

namespace hg {
namespace {

template <class V, int D, class Rule>
class ChunkSearch : RangeTest<V, D, Rule> {
  using Test = RangeTest<V, D, Rule>;
  using Test::consume;
  using Test::has_room_for;
  using Test::kLanes;
  using Test::kParts;
  using Test::points_;
  using Test::push;
  using Test::search_reach;
  using typename Test::F;
  using typename Test::I;
  using typename Test::M;

 public:
  ChunkSearch(const PointArrays &points, const ChunkTable &chunks, const PointArrays &particles, PairStream *stream)
      : Test(points, particles, stream),
        chunks_(chunks),
        inverse_(V::set(chunks.inverse_cell)),
        width_(V::set(chunks.row_width)) {}

  // A particle against those behind it in its own row and in half of the neighbouring rows.
  bool own_level(uint32_t begin, uint32_t end) {
    for (uint32_t block = begin; block < end; block += kBlock) {
      load_block(block, end);
      rest_of_own_row();
      own_level_row(1, 1, 0);
      if constexpr (D == 3) {
        for (int32_t dy = -1; dy <= 1; dy++) own_level_row(3 + dy, dy, 1);
      }
      if (!has_room_for(kStencilRows * kBlock) && !consume()) return false;
    }
    return consume();
  }

  // Points against chunks that are listed as seen from a place near them.
  bool near_chunks(uint32_t begin, uint32_t end, const int32_t *place, const NearChunks &near) {
    const float slack = chunks_.slack + static_cast<float>(kFarSlack);
    for (uint32_t i = begin; i < end; i++) {
      const F x = offset(points_.x[i], place[0]), y = offset(points_.y[i], place[1]);
      const F z = D == 3 ? offset(points_.z[i], place[2]) : V::set(0.0f);
      const F reach = search_reach(V::set(points_.radius[i]), chunks_.largest_radius, slack);
      const F reach2 = V::mul(reach, reach);
      for (uint32_t at = 0; at < near.count; at += kLanes) {
        const I lane = V::add(V::set(static_cast<int32_t>(at)), V::iota());
        F half2 = less_gap2(reach2, V::sub(V::load(near.y + at), y));
        if constexpr (D == 3) half2 = less_gap2(half2, V::sub(V::load(near.z + at), z));
        const M listed = V::greater(V::set(static_cast<int32_t>(near.count)), lane);
        const M meets = V::both(listed, V::less(V::set(0.0f), half2));
        if (V::bits(meets) == 0) continue;
        const F half = V::sqrt(V::max(V::set(0.0f), half2)), from_corner = V::sub(x, V::load(near.x + at));
        push_cells(V::set(static_cast<int32_t>(i)), V::load(near.cell + at), from_corner, half, meets);
        if (!has_room_for(kBlock) && !consume()) return false;
      }
    }
    return consume();
  }

 private:
  struct Part {
    I index, chunk;
    M active;
    F x, y, z;  // from the corner of the chunk; x in cells, and from the chunk before it
    F reach, reach2;
  };

  void load_block(uint32_t block, uint32_t end) {
    for (uint32_t n = 0; n < kParts; n++) {
      Part &p = part_[n];
      const uint32_t i = block + n * kLanes;
      p.index = V::add(V::set(static_cast<int32_t>(i)), V::iota());
      p.active = V::greater(V::set(static_cast<int32_t>(end)), p.index);
      // Parts wholly beyond the end would read outside the padding.
      const uint32_t at = i < end ? i : block;
      p.chunk = V::load(reinterpret_cast<const int32_t *>(chunks_.chunk_of + at));
      p.x = V::add(V::mul(from_corner(0, p, points_.x + at), inverse_), V::set(static_cast<float>(kChunkCells)));
      p.y = from_corner(1, p, points_.y + at);
      p.z = D == 3 ? from_corner(2, p, points_.z + at) : V::set(0.0f);
      p.reach = search_reach(V::load(points_.radius + at), chunks_.largest_radius, chunks_.slack);
      p.reach2 = V::mul(p.reach, p.reach);
    }
  }

  F from_corner(int axis, const Part &p, const int32_t *x) const {
    return V::to_float(V::sub(V::load(x), gather(chunks_.origin[axis], p.chunk, p.active)));
  }

  static I gather(const int32_t *p, I i, M m) { return V::gather_near(reinterpret_cast<const uint32_t *>(p), i, m); }
  static F offset(int32_t x, int32_t place) { return V::set(static_cast<float>(near_difference(x, place))); }

  void rest_of_own_row() {
    for (uint32_t n = 0; n < kParts; n++) {
      const Part &p = part_[n];
      const Row row(gather(chunks_.word[0], p.chunk, p.active));
      push(p.index, V::add(p.index, V::set(1)), row.end(*this, V::add(p.x, V::mul(p.reach, inverse_)), p.active),
           p.active);
    }
  }

  void own_level_row(int32_t stencil_row, int32_t dy, int32_t dz) {
    for (uint32_t n = 0; n < kParts; n++) {
      const Part &p = part_[n];
      F half2 = p.reach2;
      if (dy != 0) half2 = less_square(half2, dy < 0 ? p.y : V::sub(width_, p.y));
      if (dz != 0) half2 = less_square(half2, V::sub(width_, p.z));
      const M meets = V::both(p.active, V::less(V::set(0.0f), half2));
      if (V::bits(meets) == 0) continue;
      const Row row(gather(chunks_.word[stencil_row], p.chunk, p.active));
      const M here = V::both(meets, V::less(row.first, row.last));
      if (V::bits(here) == 0) continue;
      const F half = V::mul(V::sqrt(V::max(V::set(0.0f), half2)), inverse_);
      push(p.index, row.begin(*this, V::sub(p.x, half), here), row.end(*this, V::add(p.x, half), here), here);
    }
  }

  static F less_square(F half2, F gap) {
    const F positive = V::max(V::set(0.0f), gap);
    return V::sub(half2, V::mul(positive, positive));
  }
  // Of a row whose lower edge lies at `edge` from the point.
  F less_gap2(F half2, F edge) const {
    return less_square(half2, V::max(edge, V::sub(V::set(0.0f), V::add(edge, width_))));
  }

  // Three chunks of a row, of which the word tells those that exist. Ends are in cells from the first of the three.
  struct Row {
    explicit Row(I word)
        : word_cells(V::halve(V::bit_and(word, V::set(-ChunkWord::kFlags)))),
          first(V::mul(V::to_float(V::bit_and(word, V::set(ChunkWord::kFirst))), V::set(8.0f))),
          last(V::mul(V::to_float(V::bit_and(word, V::set(ChunkWord::kLast))), V::set(2.0f))) {}
    I begin(const ChunkSearch &search, F x, M wanted) const { return search.cell(word_cells, within(x), wanted); }
    I end(const ChunkSearch &search, F x, M wanted) const {
      return search.cell(word_cells, within(V::add(x, V::set(1.0f))), wanted);
    }
    I within(F x) const { return V::truncate(V::min(V::max(x, first), last)); }

    I word_cells;   // of the middle chunk
    F first, last;  // cells that exist
  };
  I cell(I middle, I from_first, M wanted) const {
    const I cell = V::add(middle, V::sub(from_first, V::set(kChunkCells)));
    return V::gather_near(chunks_.cell_begin, cell, wanted);
  }

  // The cells of single chunks from x - half to x + half, x seen from their corners.
  void push_cells(I point, I chunk_cell, F x, F half, M meets) {
    const F zero = V::set(0.0f), most = V::set(static_cast<float>(kChunkCells));
    const F low = V::mul(V::sub(x, half), inverse_), high = V::mul(V::add(x, half), inverse_);
    const I first = V::truncate(V::min(V::max(low, zero), most));
    const I beyond = V::truncate(V::min(V::max(V::add(high, V::set(1.0f)), zero), most));
    const M some = V::both(meets, V::greater(beyond, first));
    push(point, V::gather(chunks_.cell_begin, V::add(chunk_cell, first), some),
         V::gather(chunks_.cell_begin, V::add(chunk_cell, beyond), some), some);
  }

  const ChunkTable &chunks_;
  F inverse_, width_;
  Part part_[kParts];
};

template <class V, int D, class Rule>
bool own_chunks(const PointArrays &points, uint32_t begin, uint32_t end, const ChunkTable &chunks, PairStream *stream) {
  return ChunkSearch<V, D, Rule>(points, chunks, points, stream).own_level(begin, end);
}

template <class V, int D, class Rule>
bool near_chunks(const PointArrays &points, const ChunkGroup &group, const ChunkTable &chunks, const NearChunks &near,
                 const PointArrays &particles, PairStream *stream) {
  return ChunkSearch<V, D, Rule>(points, chunks, particles, stream)
      .near_chunks(group.begin, group.end, group.place, near);
}

template <class V, int D, class Rule>
constexpr ChunkSearchKernel make_chunk_search() {
  return {own_chunks<V, D, Rule>, near_chunks<V, D, Rule>};
}

}  // namespace
}  // namespace hg
