// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The contact detection of one level against another (the paper's section 2.2), one source for all instruction sets: V
// wraps the vectors of one of them, Rule says when particles interact. Particles go through the stencil of rows in
// blocks of 16. First find where each particle's candidates begin and end in each row (generate), then test them
// (consume). The order of the pairs depends on the blocks alone, not on V.
//
// Everything here is in an unnamed namespace: each instruction set compiles its own copy, none may leak into another.
#pragma once

#include "src/exact/fast_test.hpp"
#include "src/kernels/kernel_set.hpp"
#include "src/kernels/undecided.hpp"

namespace hg {
namespace {

constexpr uint32_t kMaxRanges = 1024;  // candidate ranges collected before they are tested
constexpr int32_t kManyRows = 3 * 16;  // rows above which lanes stand for rows instead of particles

// Candidates [begin, end) of one point.
struct Ranges {
  uint32_t count = 0;
  uint32_t point[kMaxRanges + kPadding], begin[kMaxRanges + kPadding], end[kMaxRanges + kPadding];
};

template <class V, int D, class Rule>
class LevelSearch {
  using F = typename V::Float;
  using I = typename V::Int;
  using M = typename V::Mask;
  static constexpr uint32_t kLanes = V::kLanes;
  static constexpr uint32_t kParts = kBlock / kLanes;  // vectors per block

 public:
  LevelSearch(const PointArrays &points, const CellTable &cells, const PointArrays &particles, PairStream *stream)
      : points_(points), cells_(cells), particles_(particles), stream_(stream) {
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
      if (ranges_.count > kMaxRanges - 5 * kBlock && !consume()) return false;
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
  // ---- generate

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

  // The half edge a of the search box (Eq. 4), with the largest radius of the level in place of s_h / 2.
  void set_reach(Part &p, F radius) const {
    const F reach = Rule::template base<V>(radius, V::set(cells_.largest_radius));
    p.reach = V::mul(V::add(reach, V::set(kSearchSlack)), V::set(kSearchScale));
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
    const I first = V::add(row, cell_at(0, V::sub(x, half)));
    const I last = V::add(row, cell_at(0, V::add(x, half)));
    push(point, V::gather(cells_.cell_begin, first, meets),
         V::gather(cells_.cell_begin, V::add(last, V::set(1)), meets), meets);
  }

  void rest_of_own_row() {
    for (uint32_t n = 0; n < kParts; n++) {
      const Part &p = part_[n];
      const I last = V::add(row_begin(p.row_y, p.row_z), cell_at(0, V::add(p.x, p.reach)));
      push(p.index, V::add(p.index, V::set(1)), V::gather(cells_.cell_begin, V::add(last, V::set(1)), p.active),
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
        if (!have_room(stream_, piece_end - begin + kPadding)) return false;
        test(ranges_.point[k], begin, piece_end);
        begin = piece_end;
      } while (begin < end);
    }
    return true;
  }

  void test(uint32_t i, uint32_t begin, uint32_t end) {
    // Locals, as the compiler must assume that writing pairs changes what members point to.
    const PointArrays others = particles_;
    const I x = V::set(points_.x[i]), y = V::set(points_.y[i]), z = V::set(D == 3 ? points_.z[i] : 0);
    const F radius = V::set(points_.radius[i]), band_constant = V::set(stream_->judge.band_constant);
    const uint32_t slot = points_.slot[i];
    const int32_t offset = stream_->judge.id_offset;
    hg_pair *next = stream_->output.next;
    for (uint32_t j = begin; j < end; j += kLanes) {
      const F dx = V::to_float(V::sub(x, V::load(others.x + j)));
      const F dy = V::to_float(V::sub(y, V::load(others.y + j)));
      F d2 = V::add(V::mul(dx, dx), V::mul(dy, dy));
      if constexpr (D == 3) {
        const F dz = V::to_float(V::sub(z, V::load(others.z + j)));
        d2 = V::add(d2, V::mul(dz, dz));
      }
      const auto verdict = fast_test<V>(d2, Rule::template base<V>(radius, V::load(others.radius + j)), band_constant);
      const uint32_t here = lanes_before(end - j);
      const uint32_t found = verdict.possible() & here;
      if (kLanes == 1 && found == 0) continue;
      const uint32_t sure = verdict.sure() & here;
      if (__builtin_expect(found != sure, 0)) next = leave_undecided(i, j, found, found ^ sure, next);
      next = V::emit(next, slot, others.slot + j, found, offset);
    }
    stream_->output.next = next;
    stream_->candidate_total += end - begin;
  }

  static uint32_t lanes_before(uint32_t count) { return count >= kLanes ? (1u << kLanes) - 1u : (1u << count) - 1u; }

  // Notes which of the pairs about to be written at `next` are undecided. Returns where to write, as deciding the ones
  // before may take some out.
  __attribute__((noinline)) hg_pair *leave_undecided(uint32_t i, uint32_t j, uint32_t found, uint32_t undecided,
                                                     hg_pair *next) {
    if (stream_->undecided_count + kLanes > kMaxUndecided) {
      stream_->output.next = next;
      stream_->judge.decide(stream_);
      next = stream_->output.next;
    }
    const Image image = points_.image != nullptr ? points_.image[i] : kNoImage;
    const uint32_t slot = points_.slot[i];
    fetch_ahead(stream_->judge, slot);
    for (; undecided != 0; undecided &= undecided - 1) {
      const auto lane = static_cast<uint32_t>(__builtin_ctz(undecided));
      const uint32_t other = particles_.slot[j + lane];
      fetch_ahead(stream_->judge, other);
      note_undecided(stream_, {next + __builtin_popcount(found & ((1u << lane) - 1u)), slot, other, image});
    }
    return next;
  }

  const PointArrays &points_;
  const CellTable &cells_;
  const PointArrays &particles_;
  PairStream *stream_;
  F inverse_[3], width_[3], last_[3];
  Part part_[kParts];
  Ranges ranges_;
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
