// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Tests stored candidates at the places of this step, one source for all instruction sets (search.hpp). Candidates lie
// in the order of the search, so both of their records are mostly in cache; each is one load of 16 bytes.
#pragma once

#include "src/kernels/kernel.hpp"

namespace hg {
namespace {

template <class V, bool MaxRange>
class Filter {
  using F = typename V::Float;
  using I = typename V::Int;
  static constexpr size_t kLanes = V::kLanes;

 public:
  Filter(const FilterInput &input, PairSink *sink) : input_(input), sink_(sink) {}

  bool run() {
    for (size_t first = 0; first < input_.count; first += kMaxPiece) {
      const size_t count = input_.count - first < kMaxPiece ? input_.count - first : kMaxPiece;
      const size_t room = count + kPadding;
      if (static_cast<size_t>(sink_->limit - sink_->next) < room && !sink_->make_room(sink_, room)) return false;
      piece(input_.pairs + first, count);
    }
    return true;
  }

 private:
  void piece(const hg_pair *pairs, size_t count) {
    points_from_ = sink_->next;
    const size_t whole = count / kLanes * kLanes;
    for (size_t k = 0; k < whole; k += kLanes) test(pairs + k, kLanes);
    if (whole < count) {
      hg_pair rest[kLanes] = {};
      for (size_t k = whole; k < count; k++) rest[k - whole] = pairs[k];
      test(rest, count - whole);
    }
    points_to_slots();
    sink_->candidate_count += static_cast<int64_t>(count);
  }

  // The fast test of search.hpp.
  void test(const hg_pair *pairs, size_t count) {
    const Apart apart = apart_of(pairs);
    const F dx = V::to_float(apart.x), dy = V::to_float(apart.y), dz = V::to_float(apart.z);
    const F d2 = V::add(V::add(V::mul(dx, dx), V::mul(dy, dy)), V::mul(dz, dz));
    const F t = V::sub(d2, V::mul(apart.reach, apart.reach));
    const F band = V::add(V::mul(apart.reach, V::add(V::mul(apart.reach, V::set(kBandSquare)), V::set(kBandLinear))),
                          V::set(sink_->band_constant));
    const auto here = static_cast<uint32_t>((uint64_t{1} << count) - 1);
    const uint32_t found = V::bits(V::less(t, band)) & here;
    const uint32_t sure = V::bits(V::less(V::add(t, band), V::set(0.0f)));
    if (__builtin_expect((found & ~sure) != 0, 0)) leave_open(pairs, found, found & ~sure);
    hg_pair *next = sink_->next;
    for (size_t k = 0; k < kLanes; k++) {
      *next = pairs[k];
      next += found >> k & 1u;
    }
    sink_->next = next;
  }

  struct Apart {
    I x, y, z;
    F reach;
  };

  Apart apart_of(const hg_pair *pairs) const {
    Apart apart;
    const Record *points = input_.points;
    if constexpr (kLanes == 1) {
      const Record a = points[pairs->a], b = points[pairs->b];
      apart.x = a.x - b.x;
      apart.y = a.y - b.y;
      apart.z = a.z - b.z;
      apart.reach = reach_of(a.radius, b.radius);
    } else {
      I a[4], b[4], d[4];
      for (size_t k = 0; k < 4; k++) {
        a[k] = V::records(points, &pairs[k].a);
        b[k] = V::records(points, &pairs[k].b);
        d[k] = V::sub(a[k], b[k]);
      }
      const I low = V::low_words(d[0], d[1]), high = V::low_words(d[2], d[3]);
      apart.x = V::low_doubles(low, high);
      apart.y = V::high_doubles(low, high);
      apart.z = V::low_doubles(V::high_words(d[0], d[1]), V::high_words(d[2], d[3]));
      apart.reach = reach_of(radii(a), radii(b));
    }
    return apart;
  }

  static F radii(const I *records) {
    return V::as_float(V::high_doubles(V::high_words(records[0], records[1]), V::high_words(records[2], records[3])));
  }

  static F reach_of(F ri, F rj) { return MaxRange ? V::max(ri, rj) : V::add(ri, rj); }

  __attribute__((noinline)) void leave_open(const hg_pair *pairs, uint32_t found, uint32_t open) {
    if (sink_->open_count + kLanes > kMaxOpen) {
      points_to_slots();
      sink_->settle(sink_);
      points_from_ = sink_->next;
    }
    for (; open != 0; open &= open - 1) {
      const auto lane = static_cast<uint32_t>(__builtin_ctz(open));
      hg_pair *at = sink_->next + __builtin_popcount(found & ((1u << lane) - 1u));
      const auto a = static_cast<uint32_t>(pairs[lane].a), b = static_cast<uint32_t>(pairs[lane].b);
      fetch_ahead(input_.slot[a]);
      fetch_ahead(input_.slot[b]);
      sink_->open[sink_->open_count++] = {at, a, b, kItself};
    }
  }

  void fetch_ahead(uint32_t slot) const {
    __builtin_prefetch(sink_->centers + static_cast<size_t>(slot) * sink_->dimension);
    __builtin_prefetch(sink_->radii + slot);
  }

  // Found pairs stand as points until here: in one loop over many the few of each test cost no mispredicted branches.
  void points_to_slots() {
    const uint32_t *slots = input_.slot;
    const int32_t offset = sink_->id_offset;
    for (hg_pair *p = points_from_; p < sink_->next; p++) {
      const auto a = static_cast<int32_t>(slots[p->a]), b = static_cast<int32_t>(slots[p->b]);
      *p = {(a < b ? a : b) + offset, (a < b ? b : a) + offset};
    }
  }

  const FilterInput &input_;
  PairSink *sink_;
  hg_pair *points_from_ = nullptr;  // from here on pairs are points
};

template <class V, bool MaxRange>
bool filter(const FilterInput &input, PairSink *sink) {
  return Filter<V, MaxRange>(input, sink).run();
}

}  // namespace
}  // namespace hg
