// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/pairs/pair_order.hpp"

#include "src/kernels/kernel_set.hpp"

#include <algorithm>
#include <numeric>

namespace hg {
namespace {

constexpr size_t kBucket = 4096;  // particles: their counters fit into the nearest cache

uint32_t distance(int32_t from, int32_t to) { return static_cast<uint32_t>(to) - static_cast<uint32_t>(from); }

// body(p) for each p below `count`, from four places in turns: near pairs often have the same a, and what is added to a
// counter must wait for what was added to it just before.
template <class Body>
void from_four_places(size_t count, Body &&body) {
  const size_t part = count / 4;
  for (size_t p = 0; p < part; p++) {
    for (size_t k = 0; k < 4; k++) body(p + k * part);
  }
  for (size_t p = 4 * part; p < count; p++) body(p);
}

}  // namespace

void PairOrder::ascend(hg_pair *pairs, size_t count, size_t slots, int32_t base) {
  if (count > most_counted_ || is_scattered(count, slots, [pairs](size_t p) { return pairs[p].a; })) {
    ascend_by_buckets(pairs, count, slots, base);
  } else {
    write_ascending({pairs, count, slots, base, base}, pairs);
  }
}

void PairOrder::ascend_by_buckets(hg_pair *pairs, size_t count, size_t slots, int32_t base) {
  fill_buckets({pairs, count, slots, base, base});
  hg_pair *bucket = bucketed_.data();
  for (size_t first = 0; first < slots; first += kBucket) {
    hg_pair *const end = bucketed_.data() + bucket_end_[first / kBucket];
    const auto size = static_cast<size_t>(end - bucket);
    if (size > most_counted_) {
      std::sort(bucket, end, comes_first);
      pairs = std::copy(bucket, end, pairs);
    } else {
      const int32_t first_id = base + static_cast<int32_t>(first);
      pairs = write_ascending({bucket, size, std::min(kBucket, slots - first), first_id, base}, pairs);
    }
    bucket = end;
  }
}

void PairOrder::fill_buckets(const Run &all) {
  const size_t buckets = (all.slots + kBucket - 1) / kBucket;
  bucket_end_.require_room(buckets);
  bucketed_.require_room(all.count);
  size_t *next = bucket_end_.data();
  hg_pair *bucketed = bucketed_.data();
  std::fill(next, next + buckets, size_t{0});
  from_four_places(all.count, [&](size_t p) { next[distance(all.base, all.pairs[p].a) / kBucket]++; });
  std::exclusive_scan(next, next + buckets, next, size_t{0});
  for (size_t p = 0; p < all.count; p++) bucketed[next[distance(all.base, all.pairs[p].a) / kBucket]++] = all.pairs[p];
}

// Returns the end of what was written, which may be where the run itself stands.
hg_pair *PairOrder::write_ascending(const Run &run, hg_pair *to) {
  fill_rows(run);
  return active_kernels().order({partners_.data(), row_end_.data(), run.slots, run.first_id, run.base}, to);
}

// The partners of each particle together, those of many in order.
void PairOrder::fill_rows(const Run &run) {
  row_end_.require(run.slots);
  partners_.require_room(run.count + kPadding);
  uint32_t *next = row_end_.data(), *partners = partners_.data();
  std::fill(next, next + run.slots, uint32_t{0});
  from_four_places(run.count, [=](size_t p) { next[distance(run.first_id, run.pairs[p].a)]++; });
  uint32_t sum = 0, longest = 0;
  for (size_t row = 0; row < run.slots; row++) {
    const uint32_t size = next[row];
    longest = std::max(longest, size);
    next[row] = sum;
    __builtin_prefetch(partners + sum, 1);  // filled in any order
    sum += size;
  }
  from_four_places(run.count, [=](size_t p) {
    partners[next[distance(run.first_id, run.pairs[p].a)]++] = distance(run.base, run.pairs[p].b);
  });
  if (longest <= kMostSorted) return;
  uint32_t begin = 0;
  for (size_t row = 0; row < run.slots; row++) {
    if (next[row] - begin > kMostSorted) std::sort(partners + begin, partners + next[row]);
    begin = next[row];
  }
}

}  // namespace hg
