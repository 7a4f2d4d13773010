// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Brings a list of pairs into ascending order.
#pragma once

#include "src/base/memory.hpp"

#include <hgrid/types.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace hg {

inline bool comes_first(const hg_pair &p, const hg_pair &q) { return p.a < q.a || (p.a == q.a && p.b < q.b); }

// Whether of `count` numbers, number(k), more than a quarter are farther than that from the one before. Looks at some.
template <class Number>
bool jump_about(size_t count, int64_t far, Number &&number) {
  constexpr size_t kSamples = 1024;
  size_t jumps = 0, seen = 0;
  for (size_t k = 1; k < count; k += count / kSamples + 1) {
    jumps += std::abs(int64_t{number(k)} - number(k - 1)) > far ? 1 : 0;
    seen++;
  }
  return 4 * jumps > seen;
}

// Of so many particles that caches do not hold what belongs to them all: do successive pairs often have an a, first(p),
// too far from the last one's for caches? Near pairs stand together, so this tells ids in any order from those that
// follow space.
template <class First>
bool is_scattered(size_t pairs, size_t particles, First &&first) {
  constexpr size_t kInCache = size_t{1} << 18;
  return particles > kInCache && jump_about(pairs, 1 << 16, first);
}

class PairOrder {
 public:
  // `most_counted`: more pairs are not counted together.
  explicit PairOrder(Memory &memory, size_t most_counted = UINT32_MAX)
      : most_counted_(most_counted), row_end_(memory), partners_(memory), bucket_end_(memory), bucketed_(memory) {}

  // Orders pairs of slots + `base`, a <= b, by (a, b). There must be room for kPadding pairs behind them. O(slots +
  // pairs) but for sorting within the pairs of one a.
  void ascend(hg_pair *pairs, size_t count, size_t slots, int32_t base);

 private:
  // Pairs of consecutive particles, `first_id` the first of them.
  struct Run {
    const hg_pair *pairs;
    size_t count;
    size_t slots;
    int32_t first_id, base;
  };

  void ascend_by_buckets(hg_pair *pairs, size_t count, size_t slots, int32_t base);
  void fill_buckets(const Run &all);
  hg_pair *write_ascending(const Run &run, hg_pair *to);
  void fill_rows(const Run &run);

  size_t most_counted_;
  Buffer<uint32_t> row_end_;   // of each particle's partners
  Buffer<uint32_t> partners_;  // the slots b, by a
  Buffer<size_t> bucket_end_;
  Buffer<hg_pair> bucketed_;  // the pairs, by the bucket that a falls into
};

}  // namespace hg
