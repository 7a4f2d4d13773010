// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The contact detection of one level against another (the paper's section 2.2), one source for all instruction sets: V
// wraps the vectors of one of them, Rule says when particles interact. Particles go through the stencil of rows in
// blocks of 16. First find where each particle's candidates begin and end in each row (generate), then test them
// (consume). The order of the pairs depends on the blocks alone, not on V.
//
// Everything here is in an unnamed namespace: each instruction set compiles its own copy, none may leak into another.
#pragma once

#include "src/kernels/range_test.hpp"

namespace hg {
namespace {

constexpr int32_t kManyRows = 3 * 16;  // rows above which lanes stand for rows instead of particles

template <class V, int D, class Rule>
class LevelSearch : RangeTest<V, D, Rule> {
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
  LevelSearch(const PointArrays &points, const CellTable &cells, const PointArrays &particles, PairStream *stream)
      : Test(points, particles, stream), cells_(cells) {
    for (int axis = 0; axis < 3; axis++) {
      inverse_[axis] = V::set(cells.inverse_width[axis]);
      width_[axis] = V::set(cells.width[axis]);
      last_[axis] = V::set(last_of(cells, axis));
    }
  }

  // The first step: a particle against those behind it in its own row and in half of the neighbouring rows.
  bool own_level(uint32_t begin, uint32_t end) {
    for (uint32_t block = begin; block < end; block += kBlock) {
      load_block(block, end);
      rest_of_own_row();
      own_level_row(1, 0);
      if constexpr (D == 3) {
        for (int32_t dy = -1; dy <= 1; dy++) own_level_row(dy, 1);
      }
      if (!has_room_for(5 * kBlock) && !consume()) return false;
    }
    return consume();
  }

  // The second step, towards one finer level: all rows that the search box meets.
  bool cross_level(uint32_t begin, uint32_t end) {
    for (uint32_t block = begin; block < end; block += kBlock) {
      load_block(block, end);
      if (!cross_level_block(block, end)) return false;
    }
    return consume();
  }

 private:
  // The block's particles, lane by lane: positions, how far they search, and their rows.
  struct Part {
    I index;
    M active;
    F x, y, z, reach, reach2;
    I row_y, row_z;
  };

  void load_block(uint32_t block, uint32_t end) {
    for (uint32_t n = 0; n < kParts; n++) {
      Part &p = part_[n];
      const uint32_t i = block + n * kLanes;
      p.index = V::add(V::set(static_cast<int32_t>(i)), V::iota());
      p.active = V::greater(V::set(static_cast<int32_t>(end)), p.index);
      // Parts wholly beyond the end would read outside the padding.
      const uint32_t at = i < end ? i : block;
      p.x = V::to_float(V::load(points_.x + at));
      p.y = V::to_float(V::load(points_.y + at));
      p.z = D == 3 ? V::to_float(V::load(points_.z + at)) : V::set(0.0f);
      set_reach(p, V::load(points_.radius + at));
      p.row_y = cell_at(1, p.y);
      p.row_z = D == 3 ? cell_at(2, p.z) : V::set(0);
    }
  }

  void set_reach(Part &p, F radius) const {
    p.reach = search_reach(radius, cells_.largest_radius, kSearchSlack);
    p.reach2 = V::mul(p.reach, p.reach);
  }

  I cell_at(int axis, F x) const { return cell_of<V>(x, inverse_[axis], last_[axis]); }

  // Distance from x to the nearest point of row c.
  F gap_to(int axis, I c, F x) const {
    const F below = V::mul(V::to_float(c), width_[axis]);
    const F above = V::mul(V::to_float(V::add(c, V::set(1))), width_[axis]);
    return V::max(V::set(0.0f), V::max(V::sub(below, x), V::sub(x, above)));
  }

  // Index of the first cell of row (y, z).
  I row_begin(I y, I z) const {
    const I row = D == 3 ? V::add(V::mul(z, V::set(cells_.count[1])), y) : y;
    return V::mul(row, V::set(cells_.count[0]));
  }

  // What spheres of squared radius half2, their chord with the row, can meet in a row.
  void push_chord(I point, F x, F half2, I row, M wanted) {
    const M meets = V::both(wanted, V::less(V::set(0.0f), half2));
    if (V::bits(meets) == 0) return;
    const F half = V::sqrt(V::max(V::set(0.0f), half2));
    const I first = V::add(row, cell_at(0, V::sub(x, half)));
    const I last = V::add(row, cell_at(0, V::add(x, half)));
    push(point, V::gather_near(cells_.cell_begin, first, meets),
         V::gather_near(cells_.cell_begin, V::add(last, V::set(1)), meets), meets);
  }

  void rest_of_own_row() {
    for (uint32_t n = 0; n < kParts; n++) {
      const Part &p = part_[n];
      const I last = V::add(row_begin(p.row_y, p.row_z), cell_at(0, V::add(p.x, p.reach)));
      push(p.index, V::add(p.index, V::set(1)), V::gather_near(cells_.cell_begin, V::add(last, V::set(1)), p.active),
           p.active);
    }
  }

  void own_level_row(int32_t dy, int32_t dz) {
    for (uint32_t n = 0; n < kParts; n++) {
      const Part &p = part_[n];
      const I y = V::add(p.row_y, V::set(dy)), z = V::add(p.row_z, V::set(dz));
      M inside = V::both(p.active, V::greater(V::set(cells_.count[1]), y));
      if (dy < 0) inside = V::both(inside, V::greater(y, V::set(-1)));
      if (dz > 0) inside = V::both(inside, V::greater(V::set(cells_.count[2]), z));
      push_chord(p.index, p.x, chord(p, y, z, dz != 0), row_begin(y, z), inside);
    }
  }

  F chord(const Part &p, I y, I z, bool leaves_z) const {
    const F gap_y = gap_to(1, y, p.y);
    F half2 = V::sub(p.reach2, V::mul(gap_y, gap_y));
    if (D == 3 && leaves_z) {
      const F gap_z = gap_to(2, z, p.z);
      half2 = V::sub(half2, V::mul(gap_z, gap_z));
    }
    return half2;
  }

  bool cross_level_block(uint32_t block, uint32_t end) {
    I first_y[kParts], last_y[kParts], first_z[kParts], last_z[kParts];
    int32_t rows_y = 0, rows_z = 0;
    for (uint32_t n = 0; n < kParts; n++) {
      const Part &p = part_[n];
      first_y[n] = cell_at(1, V::sub(p.y, p.reach));
      last_y[n] = cell_at(1, V::add(p.y, p.reach));
      first_z[n] = D == 3 ? cell_at(2, V::sub(p.z, p.reach)) : V::set(0);
      last_z[n] = D == 3 ? cell_at(2, V::add(p.z, p.reach)) : V::set(0);
      rows_y = larger(rows_y, 1 + V::greatest(V::sub(last_y[n], first_y[n]), p.active));
      rows_z = larger(rows_z, 1 + V::greatest(V::sub(last_z[n], first_z[n]), p.active));
    }
    if (rows_y * static_cast<int64_t>(rows_z) > kManyRows) return cross_many_rows(block, end);

    for (int32_t dz = 0; dz < rows_z; dz++) {  // Eq. 5
      for (int32_t dy = 0; dy < rows_y; dy++) {
        for (uint32_t n = 0; n < kParts; n++) {
          const Part &p = part_[n];
          const I y = V::add(first_y[n], V::set(dy)), z = V::add(first_z[n], V::set(dz));
          const M outside = V::either(V::greater(y, last_y[n]), V::greater(z, last_z[n]));
          push_chord(p.index, p.x, chord(p, y, z, true), row_begin(y, z), V::without(p.active, outside));
        }
        if (!has_room_for(kBlock) && !consume()) return false;
      }
    }
    return true;
  }

  static int32_t larger(int32_t a, int32_t b) { return a > b ? a : b; }

  // Particles that reach over many rows of a much finer level: one at a time, lanes are rows along y.
  bool cross_many_rows(uint32_t block, uint32_t end) {
    const uint32_t block_end = end - block > kBlock ? block + kBlock : end;
    for (uint32_t i = block; i < block_end; i++) {
      Part p;
      p.index = V::set(static_cast<int32_t>(i));
      p.x = V::set(static_cast<float>(points_.x[i]));
      p.y = V::set(static_cast<float>(points_.y[i]));
      p.z = V::set(D == 3 ? static_cast<float>(points_.z[i]) : 0.0f);
      set_reach(p, V::set(points_.radius[i]));
      const int32_t first_y = V::first(cell_at(1, V::sub(p.y, p.reach)));
      const int32_t last_y = V::first(cell_at(1, V::add(p.y, p.reach)));
      const int32_t first_z = D == 3 ? V::first(cell_at(2, V::sub(p.z, p.reach))) : 0;
      const int32_t last_z = D == 3 ? V::first(cell_at(2, V::add(p.z, p.reach))) : 0;
      for (int32_t z = first_z; z <= last_z; z++) {
        for (int32_t y = first_y; y <= last_y; y += static_cast<int32_t>(kLanes)) {
          const I rows = V::add(V::set(y), V::iota());
          const M inside = V::greater(V::set(last_y + 1), rows);
          push_chord(p.index, p.x, chord(p, rows, V::set(z), true), row_begin(rows, V::set(z)), inside);
          if (!has_room_for(kBlock) && !consume()) return false;
        }
      }
    }
    return true;
  }

  const CellTable &cells_;
  F inverse_[3], width_[3], last_[3];
  Part part_[kParts];
};

template <class V, int D, class Rule>
bool own_level(const PointArrays &points, uint32_t begin, uint32_t end, const CellTable &cells, PairStream *stream) {
  return LevelSearch<V, D, Rule>(points, cells, points, stream).own_level(begin, end);
}

template <class V, int D, class Rule>
bool cross_level(const PointArrays &points, uint32_t begin, uint32_t end, const CellTable &cells,
                 const PointArrays &particles, PairStream *stream) {
  return LevelSearch<V, D, Rule>(points, cells, particles, stream).cross_level(begin, end);
}

template <class V, int D, class Rule>
constexpr SearchKernel make_search() {
  return {own_level<V, D, Rule>, cross_level<V, D, Rule>};
}

}  // namespace
}  // namespace hg
