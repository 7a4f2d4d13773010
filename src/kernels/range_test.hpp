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

constexpr int32_t kMatchesNone = INT32_MIN;  // no particle has such a body
constexpr uint32_t kMaxRanges = 1024;        // candidate ranges collected before they are tested

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

  bool consume() { return points_.body != nullptr ? consume_as<true>() : consume_as<false>(); }

  const PointArrays &points_;

 private:
  template <bool kBodies>
  bool consume_as() {
    // Locals, as the compiler must assume that writing pairs changes what members point to.
    const PointArrays points = points_, others = particles_;
    hg_pair *next = stream_->output.next;
    const uint32_t count = ranges_.count;
    bool go_on = true;
    int64_t candidates = 0;
    for (uint32_t k = 0; k < count && go_on; k++) {
      uint32_t begin = ranges_.begin[k];
      const uint32_t end = ranges_.end[k];
      do {
        const uint32_t piece_end = end - begin > kMaxPiece ? begin + kMaxPiece : end;
        go_on = have_room(piece_end - begin + kPadding, next);
        if (!go_on) break;
        const uint32_t tested = test<kBodies>(points, ranges_.point[k], others, begin, piece_end, next);
        candidates += tested - begin;
        begin = tested;
      } while (begin < end);
    }
    ranges_.count = 0;
    stream_->output.next = next;
    stream_->candidate_total += candidates;
    return go_on;
  }

  // Room for so many pairs at `next`, which moves where they are given another place.
  bool have_room(uint32_t pairs, hg_pair *&next) {
    if (__builtin_expect(static_cast<size_t>(stream_->output.limit - next) >= pairs, 1)) return true;
    stream_->output.next = next;
    const bool go_on = hg::have_room(stream_, pairs);
    next = stream_->output.next;
    return go_on;
  }

  // Tests candidates of point i from `begin` on, up to `end` or to where some are undecided, and returns how far it
  // came: a loop that calls nothing keeps its vectors in registers. Parts of one body are no pair.
  template <bool kBodies>
  uint32_t test(const PointArrays points, uint32_t i, const PointArrays others, uint32_t begin, uint32_t end,
                hg_pair *&next) {
    const I x = V::set(points.x[i]), y = V::set(points.y[i]), z = V::set(D == 3 ? points.z[i] : 0);
    const F radius = V::set(points.radius[i]), band_constant = V::set(stream_->judge.band_constant);
    const uint32_t slot = points.slot[i];
    const int32_t offset = stream_->judge.id_offset;
    [[maybe_unused]] I body{};
    if constexpr (kBodies) body = V::set(points.body[i] < 0 ? kMatchesNone : points.body[i]);
    uint32_t j = begin, found, sure;
    do {
      const F dx = V::to_float(V::sub(x, V::load(others.x + j)));
      const F dy = V::to_float(V::sub(y, V::load(others.y + j)));
      F d2 = V::add(V::mul(dx, dx), V::mul(dy, dy));
      if constexpr (D == 3) {
        const F dz = V::to_float(V::sub(z, V::load(others.z + j)));
        d2 = V::add(d2, V::mul(dz, dz));
      }
      const auto verdict = fast_test<V>(d2, Rule::template base<V>(radius, V::load(others.radius + j)), band_constant);
      uint32_t here = lanes_before(end - j);
      if constexpr (kBodies) here &= ~V::bits(V::equal(body, V::load(others.body + j)));
      found = verdict.possible() & here;
      sure = verdict.sure() & here;
      if (__builtin_expect(found != sure, 0)) break;
      next = V::emit(next, slot, others.slot + j, found, offset);
      j += kLanes;
    } while (j < end);
    if (__builtin_expect(found != sure, 0)) {
      next = leave_undecided(i, j, found, found ^ sure, next);
      next = V::emit(next, slot, others.slot + j, found, offset);
      j += kLanes;
    }
    return j < end ? j : end;
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
