// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Ranges of candidates and their test, the second half of every search: a search finds where the candidates of points
// begin and end (generate), then all of them are tested in order (consume). One source for all instruction sets: V
// wraps the vectors of one of them, Rule says when particles interact.
//
// Everything here is in an unnamed namespace: each instruction set compiles its own copy, none may leak into another.
#pragma once

#include "src/exact/fast_test.hpp"
#include "src/kernels/kernel_set.hpp"
#include "src/kernels/undecided.hpp"

namespace hg {
namespace {

constexpr uint32_t kMaxRanges = 1024;  // candidate ranges collected before they are tested

// Candidates [begin, end) of one point.
struct Ranges {
  uint32_t count = 0;
  uint32_t point[kMaxRanges + kPadding], begin[kMaxRanges + kPadding], end[kMaxRanges + kPadding];
};

template <class V, int D, class Rule>
class RangeTest {
 protected:
  using F = typename V::Float;
  using I = typename V::Int;
  using M = typename V::Mask;
  static constexpr uint32_t kLanes = V::kLanes;
  static constexpr uint32_t kParts = kBlock / kLanes;  // vectors per block

  // Candidates of `points` are among `particles`.
  RangeTest(const PointArrays &points, const PointArrays &particles, PairStream *stream)
      : points_(points), particles_(particles), stream_(stream) {}

  // The half edge a of the search box (Eq. 4), with the largest radius of the level in place of s_h / 2, and what a
  // search must allow for.
  static F search_reach(F radius, float largest_radius, float slack) {
    const F reach = Rule::template base<V>(radius, V::set(largest_radius));
    return V::mul(V::add(reach, V::set(slack)), V::set(kSearchScale));
  }

  bool has_room_for(uint32_t ranges) const { return ranges_.count <= kMaxRanges - ranges; }

  void push(I point, I begin, I end, M wanted) {
    const M some = V::both(wanted, V::greater(end, begin));
    const uint32_t at = ranges_.count;
    V::compress(ranges_.point + at, point, some);
    V::compress(ranges_.begin + at, begin, some);
    V::compress(ranges_.end + at, end, some);
    ranges_.count = at + V::count(some);
  }

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

  const PointArrays &points_;

 private:
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

  const PointArrays &particles_;
  PairStream *stream_;
  Ranges ranges_;
};

}  // namespace
}  // namespace hg
