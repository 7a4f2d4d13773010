// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Tests stored candidates on the caller's own doubles, for all instruction sets that can put the lanes of a few doubles
// together. A test is sure or silent, as in exact/overlap.cpp; what it leaves open, the caller of a kernel decides.
// L wraps the doubles of an instruction set.
#pragma once

#include "src/kernels/kernel_set.hpp"
#include "src/kernels/undecided.hpp"

namespace hg {
namespace {

// Covers what squared distance and squared reach are off by together, relative to them; docs/theory/exactness.md,
// section 13.
constexpr double kSquareError = 0x1p-46;

// Above it squares lose no bits to underflow. A smaller one of a distance says no more than that, one of a reach
// nothing.
constexpr double kLeastSquare = 1e-280;

constexpr size_t kDirectAhead = 64;  // pairs whose particles are on their way from memory

template <class L, int D, class Rule>
class DirectTest {
  using F = typename L::Double;

 public:
  static constexpr size_t kLanes = L::kLanes;

  explicit DirectTest(const DirectInput &input) : input_(input) {}

  struct Result {
    typename L::Pairs pairs;
    typename L::Apart apart;
    F reach;
    uint32_t found;  // the lanes whose pair interacts
  };

  // Of the pairs from `first` on, kLanes of them if there are so many.
  Result test(size_t first) {
    const size_t count = input_.count - first;
    const hg_pair *pairs = input_.pairs + first;
    if (__builtin_expect(count >= kDirectAhead + kLanes, 1)) {
      for (size_t k = 0; k < kLanes; k++) fetch(pairs[kDirectAhead + k]);
    }
    if (count >= kLanes) return test_all(pairs, (1u << kLanes) - 1u);
    hg_pair rest[kLanes] = {};
    for (size_t k = 0; k < count; k++) rest[k] = pairs[k];
    return test_all(rest, (1u << count) - 1u);
  }

  int64_t undecided() const { return undecided_; }
  int64_t exact() const { return exact_; }

 private:
  void fetch(const hg_pair &pair) const {
    for (const int32_t slot : {pair.a, pair.b}) {
      const auto at = static_cast<size_t>(static_cast<uint32_t>(slot));
      __builtin_prefetch(input_.centers + at * D);
      __builtin_prefetch(input_.radii + at);
    }
  }

  Result test_all(const hg_pair *pairs, uint32_t here) {
    Result result;
    result.pairs = L::load_pairs(pairs);
    result.apart = L::template apart<D, Rule>(input_.centers, input_.radii, pairs);
    result.reach = L::add(result.apart.base, L::set(input_.margin));
    const F x = result.apart.x, y = result.apart.y;
    F d2 = L::add(L::mul(x, x), L::mul(y, y));
    if constexpr (D == 3) d2 = L::add(d2, L::mul(result.apart.z, result.apart.z));
    const F reach2 = L::mul(result.reach, result.reach);
    const F least = L::set(kLeastSquare);
    const uint32_t possible = L::less(L::mul(d2, L::set(1 - kSquareError)), L::max(reach2, least)) & here;
    const uint32_t sure = L::less(L::mul(L::max(d2, least), L::set(1 + kSquareError)), reach2);
    result.found = possible;
    if (__builtin_expect((possible & ~sure) != 0, 0)) result.found &= ~refused(pairs, possible & ~sure);
    return result;
  }

  __attribute__((noinline)) uint32_t refused(const hg_pair *pairs, uint32_t open) {
    uint32_t all = 0;
    for (; open != 0; open &= open - 1) {
      const auto lane = static_cast<uint32_t>(__builtin_ctz(open));
      undecided_++;
      if (!input_.interact(input_.judge, pairs[lane], &exact_)) all |= 1u << lane;
    }
    return all;
  }

  const DirectInput &input_;
  int64_t undecided_ = 0, exact_ = 0;
};

template <class L, int D, class Rule>
bool direct_pairs(const DirectInput &input, PairStream *stream) {
  using Test = DirectTest<L, D, Rule>;
  Test test(input);
  bool go_on = true;
  for (size_t first = 0; go_on && first < input.count; first += kMaxPiece) {
    const size_t end = input.count - first < kMaxPiece ? input.count : first + kMaxPiece;
    go_on = have_room(stream, end - first + kPadding);
    if (!go_on) break;
    hg_pair *next = stream->output.next;
    for (size_t k = first; k < end; k += Test::kLanes) {
      const auto result = test.test(k);
      L::compress_pairs(next, result.pairs, result.found, stream->judge.id_offset);
      next += __builtin_popcount(result.found);
    }
    stream->output.next = next;
    stream->candidate_total += static_cast<int64_t>(end - first);
  }
  stream->undecided_total += test.undecided();
  stream->exact_total += test.exact();
  return go_on;
}

template <class L, int D, class Rule>
size_t direct_contacts(const DirectInput &input, ContactColumns *to) {
  using Test = DirectTest<L, D, Rule>;
  Test test(input);
  size_t k = 0, count = 0;
  for (; k < input.count && count + Test::kLanes <= to->room; k += Test::kLanes) {
    const auto result = test.test(k);
    L::compress_slots(to->a + count, to->b + count, result.pairs, result.found, to->id_offset);
    L::compress(to->component[0] + count, result.apart.x, result.found);
    L::compress(to->component[1] + count, result.apart.y, result.found);
    if constexpr (D == 3) L::compress(to->component[2] + count, result.apart.z, result.found);
    L::compress(to->reach + count, result.reach, result.found);
    count += static_cast<size_t>(__builtin_popcount(result.found));
  }
  to->count = count;
  to->undecided += test.undecided();
  to->exact += test.exact();
  return k < input.count ? k : input.count;
}

}  // namespace
}  // namespace hg
