// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Tests stored candidates at the places of this step, one source for all instruction sets (search.hpp). Candidates lie
// in the order of the search, so both of their points are mostly in cache; each is one load of 16 bytes.
#pragma once

#include "src/exact/fast_test.hpp"
#include "src/kernels/kernel_set.hpp"
#include "src/kernels/undecided.hpp"

namespace hg {
namespace {

template <class V, class Rule>
class Filter {
  using F = typename V::Float;
  using I = typename V::Int;
  static constexpr size_t kLanes = V::kLanes;

 public:
  Filter(const FilterInput &input, PairStream *stream) : input_(input), stream_(stream) {}

  bool run() {
    for (size_t first = 0; first < input_.count; first += kMaxPiece) {
      const size_t count = input_.count - first < kMaxPiece ? input_.count - first : kMaxPiece;
      if (!have_room(stream_, count + kPadding)) return false;
      piece(input_.pairs + first, count);
    }
    return true;
  }

 private:
  void piece(const hg_pair *pairs, size_t count) {
    points_from_ = stream_->output.next;
    const size_t whole = count / kLanes * kLanes;
    for (size_t k = 0; k < whole; k += kLanes) test(pairs + k, kLanes);
    if (whole < count) {
      hg_pair rest[kLanes] = {};
      for (size_t k = whole; k < count; k++) rest[k - whole] = pairs[k];
      test(rest, count - whole);
    }
    points_to_slots();
    stream_->candidate_total += static_cast<int64_t>(count);
  }

  void test(const hg_pair *pairs, size_t count) {
    const Apart apart = apart_of(pairs);
    const F dx = V::to_float(apart.x), dy = V::to_float(apart.y), dz = V::to_float(apart.z);
    const F d2 = V::add(V::add(V::mul(dx, dx), V::mul(dy, dy)), V::mul(dz, dz));
    const auto verdict = fast_test<V>(d2, apart.reach, V::set(stream_->judge.band_constant));
    const auto here = static_cast<uint32_t>((uint64_t{1} << count) - 1);
    const uint32_t found = verdict.possible() & here;
    const uint32_t sure = verdict.sure();
    if (__builtin_expect((found & ~sure) != 0, 0)) leave_undecided(pairs, found, found & ~sure);
    hg_pair *next = stream_->output.next;
    for (size_t lane = 0; lane < kLanes; lane++) {
      *next = pairs[lane];
      next += found >> lane & 1u;
    }
    stream_->output.next = next;
  }

  struct Apart {
    I x, y, z;
    F reach;
  };

  Apart apart_of(const hg_pair *pairs) const {
    Apart apart;
    const Point *points = input_.points;
    if constexpr (kLanes == 1) {
      const Point a = points[pairs->a], b = points[pairs->b];
      apart.x = a.x - b.x;
      apart.y = a.y - b.y;
      apart.z = a.z - b.z;
      apart.reach = Rule::template base<V>(a.radius, b.radius);
    } else {
      I a[4], b[4], d[4];
      for (size_t k = 0; k < 4; k++) {
        a[k] = V::load_points(points, &pairs[k].a);
        b[k] = V::load_points(points, &pairs[k].b);
        d[k] = V::sub(a[k], b[k]);
      }
      const I low = V::low_words(d[0], d[1]), high = V::low_words(d[2], d[3]);
      apart.x = V::low_doubles(low, high);
      apart.y = V::high_doubles(low, high);
      apart.z = V::low_doubles(V::high_words(d[0], d[1]), V::high_words(d[2], d[3]));
      apart.reach = Rule::template base<V>(radii(a), radii(b));
    }
    return apart;
  }

  static F radii(const I *points) {
    return V::as_float(V::high_doubles(V::high_words(points[0], points[1]), V::high_words(points[2], points[3])));
  }

  __attribute__((noinline)) void leave_undecided(const hg_pair *pairs, uint32_t found, uint32_t undecided) {
    if (stream_->undecided_count + kLanes > kMaxUndecided) {
      points_to_slots();
      stream_->judge.decide(stream_);
      points_from_ = stream_->output.next;
    }
    for (; undecided != 0; undecided &= undecided - 1) {
      const auto lane = static_cast<uint32_t>(__builtin_ctz(undecided));
      hg_pair *at = stream_->output.next + __builtin_popcount(found & ((1u << lane) - 1u));
      const auto a = static_cast<uint32_t>(pairs[lane].a), b = static_cast<uint32_t>(pairs[lane].b);
      fetch_ahead(stream_->judge, input_.slot[a]);
      fetch_ahead(stream_->judge, input_.slot[b]);
      note_undecided(stream_, {at, a, b, kNoImage});
    }
  }

  // Found pairs stand as points until here: in one loop over many the few of each test cost no mispredicted branches.
  void points_to_slots() {
    const uint32_t *slots = input_.slot;
    const int32_t offset = stream_->judge.id_offset;
    for (hg_pair *p = points_from_; p < stream_->output.next; p++) {
      const auto a = static_cast<int32_t>(slots[p->a]), b = static_cast<int32_t>(slots[p->b]);
      *p = {(a < b ? a : b) + offset, (a < b ? b : a) + offset};
    }
  }

  const FilterInput &input_;
  PairStream *stream_;
  hg_pair *points_from_ = nullptr;  // from here on pairs are points
};

template <class V, class Rule>
bool filter(const FilterInput &input, PairStream *stream) {
  return Filter<V, Rule>(input, stream).run();
}

}  // namespace
}  // namespace hg
