// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The search, one source for all instruction sets: V wraps the vector type of one of them. Particles go through the
// stencil of rows in blocks of 16. First find where each particle's candidates begin and end in each row (generate),
// then test them (consume). The order of the pairs depends on the blocks alone, not on V.
//
// Everything here is in an unnamed namespace: each instruction set compiles its own copy, none may leak into another.
#pragma once

#include "src/kernels/kernel.hpp"

#include <cfloat>

static_assert(FLT_EVAL_METHOD == 0, "extended precision would make cells and pairs depend on the compiler");

namespace hg {
namespace {

constexpr uint32_t kMaxRanges = 1024;  // candidate ranges collected before they are tested
constexpr int32_t kManyRows = 3 * 16;  // rows above which lanes stand for rows instead of particles

// Candidates [begin, end) of one point.
struct Ranges {
  uint32_t count = 0;
  uint32_t point[kMaxRanges + kPadding], begin[kMaxRanges + kPadding], end[kMaxRanges + kPadding];
};

template <class V, int D, bool MaxRange>
class Search {
  using F = typename V::Float;
  using I = typename V::Int;
  using M = typename V::Mask;
  static constexpr uint32_t kLanes = V::kLanes;
  static constexpr uint32_t kParts = kBlock / kLanes;  // vectors per block

 public:
  Search(const PointArrays &points, const CellTable &cells, const PointArrays &particles, PairSink *sink)
      : points_(points), cells_(cells), particles_(particles), sink_(sink) {
    for (int k = 0; k < 3; k++) {
      inverse_[k] = V::set(cells.inverse_width[k]);
      width_[k] = V::set(cells.width[k]);
      last_[k] = V::set(static_cast<float>(cells.count[k]) - 0.5f);
    }
  }

  bool own_level(uint32_t begin, uint32_t end) {
    for (uint32_t block = begin; block < end; block += kBlock) {
      load_block(block, end);
      rest_of_own_row();
      own_level_row(1, 0);
      if constexpr (D == 3) {
        for (int32_t dy = -1; dy <= 1; dy++) own_level_row(dy, 1);
      }
      if (ranges_.count > kMaxRanges - 5 * kBlock && !consume()) return false;
    }
    return consume();
  }

  bool cross_level(uint32_t begin, uint32_t end) {
    for (uint32_t block = begin; block < end; block += kBlock) {
      load_block(block, end);
      if (!cross_level_block(block, end)) return false;
    }
    return consume();
  }

 private:
  // ---- generate

  // Positions, windows and cells of the block's particles, lane by lane.
  struct Part {
    I index;
    M active;
    F x, y, z, window, window2;
    I row_y, row_z;
  };

  void load_block(uint32_t block, uint32_t end) {
    for (uint32_t k = 0; k < kParts; k++) {
      Part &p = part_[k];
      const uint32_t i = block + k * kLanes;
      p.index = V::add(V::set(static_cast<int32_t>(i)), V::iota());
      p.active = V::greater(V::set(static_cast<int32_t>(end)), p.index);
      // Parts wholly beyond the end would read outside the padding.
      const uint32_t at = i < end ? i : block;
      p.x = V::to_float(V::load(points_.x + at));
      p.y = V::to_float(V::load(points_.y + at));
      p.z = D == 3 ? V::to_float(V::load(points_.z + at)) : V::set(0.0f);
      const F reach = reach_of(V::load(points_.radius + at), V::set(cells_.largest_radius));
      p.window = V::mul(V::add(reach, V::set(kWindowSlack)), V::set(kWindowScale));
      p.window2 = V::mul(p.window, p.window);
      p.row_y = cell_of(1, p.y);
      p.row_z = D == 3 ? cell_of(2, p.z) : V::set(0);
    }
  }

  static F reach_of(F ri, F rj) { return MaxRange ? V::max(ri, rj) : V::add(ri, rj); }

  // The one map from coordinates to cells, for particles and for windows alike. Every step is monotone, so a particle
  // inside a window is never in a cell outside the window's cells.
  I cell_of(int axis, F x) const {
    return V::truncate(V::min(V::max(V::mul(x, inverse_[axis]), V::set(0.0f)), last_[axis]));
  }

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

  void push(I point, I begin, I end, M wanted) {
    const M some = V::both(wanted, V::greater(end, begin));
    const uint32_t at = ranges_.count;
    V::compress(ranges_.point + at, point, some);
    V::compress(ranges_.begin + at, begin, some);
    V::compress(ranges_.end + at, end, some);
    ranges_.count = at + V::count(some);
  }

  // What spheres of squared radius half2, their chord with the row, can meet in a row.
  void push_chord(I point, F x, F half2, I row, M wanted) {
    const M meets = V::both(wanted, V::less(V::set(0.0f), half2));
    if (V::bits(meets) == 0) return;
    const F half = V::sqrt(V::max(V::set(0.0f), half2));
    const I first = V::add(row, cell_of(0, V::sub(x, half)));
    const I last = V::add(row, cell_of(0, V::add(x, half)));
    push(point, V::gather(cells_.cell_begin, first, meets),
         V::gather(cells_.cell_begin, V::add(last, V::set(1)), meets), meets);
  }

  void rest_of_own_row() {
    for (uint32_t k = 0; k < kParts; k++) {
      const Part &p = part_[k];
      const I last = V::add(row_begin(p.row_y, p.row_z), cell_of(0, V::add(p.x, p.window)));
      push(p.index, V::add(p.index, V::set(1)), V::gather(cells_.cell_begin, V::add(last, V::set(1)), p.active),
           p.active);
    }
  }

  void own_level_row(int32_t dy, int32_t dz) {
    for (uint32_t k = 0; k < kParts; k++) {
      const Part &p = part_[k];
      const I y = V::add(p.row_y, V::set(dy)), z = V::add(p.row_z, V::set(dz));
      M inside = V::both(p.active, V::greater(V::set(cells_.count[1]), y));
      if (dy < 0) inside = V::both(inside, V::greater(y, V::set(-1)));
      if (dz > 0) inside = V::both(inside, V::greater(V::set(cells_.count[2]), z));
      push_chord(p.index, p.x, chord(p, y, z, dz != 0), row_begin(y, z), inside);
    }
  }

  F chord(const Part &p, I y, I z, bool leaves_z) const {
    const F gap_y = gap_to(1, y, p.y);
    F half2 = V::sub(p.window2, V::mul(gap_y, gap_y));
    if (D == 3 && leaves_z) {
      const F gap_z = gap_to(2, z, p.z);
      half2 = V::sub(half2, V::mul(gap_z, gap_z));
    }
    return half2;
  }

  bool cross_level_block(uint32_t block, uint32_t end) {
    I first_y[kParts], last_y[kParts], first_z[kParts], last_z[kParts];
    int32_t rows_y = 0, rows_z = 0;
    for (uint32_t k = 0; k < kParts; k++) {
      const Part &p = part_[k];
      first_y[k] = cell_of(1, V::sub(p.y, p.window));
      last_y[k] = cell_of(1, V::add(p.y, p.window));
      first_z[k] = D == 3 ? cell_of(2, V::sub(p.z, p.window)) : V::set(0);
      last_z[k] = D == 3 ? cell_of(2, V::add(p.z, p.window)) : V::set(0);
      rows_y = larger(rows_y, 1 + V::greatest(V::sub(last_y[k], first_y[k]), p.active));
      rows_z = larger(rows_z, 1 + V::greatest(V::sub(last_z[k], first_z[k]), p.active));
    }
    if (rows_y * static_cast<int64_t>(rows_z) > kManyRows) return cross_many_rows(block, end);

    for (int32_t dz = 0; dz < rows_z; dz++) {
      for (int32_t dy = 0; dy < rows_y; dy++) {
        for (uint32_t k = 0; k < kParts; k++) {
          const Part &p = part_[k];
          const I y = V::add(first_y[k], V::set(dy)), z = V::add(first_z[k], V::set(dz));
          const M outside = V::either(V::greater(y, last_y[k]), V::greater(z, last_z[k]));
          push_chord(p.index, p.x, chord(p, y, z, true), row_begin(y, z), V::without(p.active, outside));
        }
        if (ranges_.count > kMaxRanges - kBlock && !consume()) return false;
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
      const F reach = reach_of(V::set(points_.radius[i]), V::set(cells_.largest_radius));
      p.window = V::mul(V::add(reach, V::set(kWindowSlack)), V::set(kWindowScale));
      p.window2 = V::mul(p.window, p.window);
      const int32_t first_y = V::first(cell_of(1, V::sub(p.y, p.window)));
      const int32_t last_y = V::first(cell_of(1, V::add(p.y, p.window)));
      const int32_t first_z = D == 3 ? V::first(cell_of(2, V::sub(p.z, p.window))) : 0;
      const int32_t last_z = D == 3 ? V::first(cell_of(2, V::add(p.z, p.window))) : 0;
      for (int32_t z = first_z; z <= last_z; z++) {
        for (int32_t y = first_y; y <= last_y; y += static_cast<int32_t>(kLanes)) {
          const I rows = V::add(V::set(y), V::iota());
          const M inside = V::greater(V::set(last_y + 1), rows);
          push_chord(p.index, p.x, chord(p, rows, V::set(z), true), row_begin(rows, V::set(z)), inside);
          if (ranges_.count > kMaxRanges - kBlock && !consume()) return false;
        }
      }
    }
    return true;
  }

  // ---- consume

  bool consume() {
    const uint32_t count = ranges_.count;
    ranges_.count = 0;
    for (uint32_t k = 0; k < count; k++) {
      uint32_t begin = ranges_.begin[k];
      const uint32_t end = ranges_.end[k];
      do {
        const uint32_t piece_end = end - begin > kMaxPiece ? begin + kMaxPiece : end;
        const size_t room = piece_end - begin + kPadding;
        if (static_cast<size_t>(sink_->limit - sink_->next) < room && !sink_->make_room(sink_, room)) return false;
        test(ranges_.point[k], begin, piece_end);
        begin = piece_end;
      } while (begin < end);
    }
    return true;
  }

  // t = d^2 - R^2 in float: below -band the pair surely overlaps, from band on surely not.
  void test(uint32_t i, uint32_t begin, uint32_t end) {
    // Locals, as the compiler must assume that writing pairs changes what members point to.
    const PointArrays others = particles_;
    const I x = V::set(points_.x[i]), y = V::set(points_.y[i]), z = V::set(D == 3 ? points_.z[i] : 0);
    const F radius = V::set(points_.radius[i]), band_constant = V::set(sink_->band_constant);
    const uint32_t slot = points_.slot[i];
    const int32_t offset = sink_->id_offset;
    hg_pair *next = sink_->next;
    for (uint32_t j = begin; j < end; j += kLanes) {
      const F dx = V::to_float(V::sub(x, V::load(others.x + j)));
      const F dy = V::to_float(V::sub(y, V::load(others.y + j)));
      F d2 = V::add(V::mul(dx, dx), V::mul(dy, dy));
      if constexpr (D == 3) {
        const F dz = V::to_float(V::sub(z, V::load(others.z + j)));
        d2 = V::add(d2, V::mul(dz, dz));
      }
      const F reach = reach_of(radius, V::load(others.radius + j));
      const F t = V::sub(d2, V::mul(reach, reach));
      const F band =
          V::add(V::mul(reach, V::add(V::mul(reach, V::set(kBandSquare)), V::set(kBandLinear))), band_constant);
      const uint32_t here = lanes_before(end - j);
      const uint32_t found = V::bits(V::less(t, band)) & here;
      if (kLanes == 1 && found == 0) continue;
      const uint32_t sure = V::bits(V::less(V::add(t, band), V::set(0.0f))) & here;
      if (__builtin_expect(found != sure, 0)) next = leave_open(i, j, found, found ^ sure, next);
      next = V::emit(next, slot, others.slot + j, found, offset);
    }
    sink_->next = next;
    sink_->candidate_count += end - begin;
  }

  static uint32_t lanes_before(uint32_t count) { return count >= kLanes ? (1u << kLanes) - 1u : (1u << count) - 1u; }

  // Notes which of the pairs about to be written at `next` are open. Returns where to write, as settling the ones
  // before may take some out.
  __attribute__((noinline)) hg_pair *leave_open(uint32_t i, uint32_t j, uint32_t found, uint32_t open, hg_pair *next) {
    if (sink_->open_count + kLanes > kMaxOpen) {
      sink_->next = next;
      sink_->settle(sink_);
      next = sink_->next;
    }
    const uint8_t image = points_.image != nullptr ? points_.image[i] : kItself;
    const uint32_t slot = points_.slot[i];
    fetch_ahead(slot);
    for (; open != 0; open &= open - 1) {
      const auto lane = static_cast<uint32_t>(__builtin_ctz(open));
      const uint32_t other = particles_.slot[j + lane];
      fetch_ahead(other);
      hg_pair *at = next + __builtin_popcount(found & ((1u << lane) - 1u));
      sink_->open[sink_->open_count++] = {at, slot, other, image};
    }
    return next;
  }

  void fetch_ahead(uint32_t slot) const {
    const double *center = sink_->centers + static_cast<size_t>(slot) * D;
    __builtin_prefetch(center);
    __builtin_prefetch(center + (D - 1));  // may lie on the next cache line
    __builtin_prefetch(sink_->radii + slot);
  }

  const PointArrays &points_;
  const CellTable &cells_;
  const PointArrays &particles_;
  PairSink *sink_;
  F inverse_[3], width_[3], last_[3];
  Part part_[kParts];
  Ranges ranges_;
};

template <class V, int D, bool MaxRange>
bool own_level(const PointArrays &points, uint32_t begin, uint32_t end, const CellTable &cells, PairSink *sink) {
  return Search<V, D, MaxRange>(points, cells, points, sink).own_level(begin, end);
}

template <class V, int D, bool MaxRange>
bool cross_level(const PointArrays &points, uint32_t begin, uint32_t end, const CellTable &cells,
                 const PointArrays &particles, PairSink *sink) {
  return Search<V, D, MaxRange>(points, cells, particles, sink).cross_level(begin, end);
}

template <class V, int D, bool MaxRange>
constexpr SearchKernel make_search() {
  return {own_level<V, D, MaxRange>, cross_level<V, D, MaxRange>};
}

}  // namespace
}  // namespace hg
