// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/pairs/pair_order.hpp"

#include "src/kernels/kernel_set.hpp"

#include <algorithm>

namespace hg {
namespace {

constexpr size_t kBucket = 4096;              // particles: their counters fit into the nearest cache
constexpr size_t kInCache = size_t{1} << 18;  // particles whose counters and partners all stay in cache

uint32_t distance(int32_t from, int32_t to) { return static_cast<uint32_t>(to) - static_cast<uint32_t>(from); }

bool comes_first(const hg_pair &p, const hg_pair &q) { return p.a < q.a || (p.a == q.a && p.b < q.b); }

// Are the a of successive pairs often far apart? Near pairs stand together, so this tells ids in any order from those
// that follow space.
bool is_scattered(const hg_pair *pairs, size_t count) {
  constexpr size_t kSamples = 1024;
  size_t far = 0, seen = 0;
  for (size_t p = 1; p < count; p += count / kSamples + 1) {
    const auto [low, high] = std::minmax(pairs[p - 1].a, pairs[p].a);
    far += distance(low, high) > kBucket ? 1 : 0;
    seen++;
  }
  return 4 * far > seen;
}

// Counts become the places where each one's share begins. Returns the largest count.
template <class Count>
Count counts_to_begins(Count *counts, size_t size) {
  Count sum = 0, largest = 0;
  for (size_t k = 0; k < size; k++) {
    const Count here = counts[k];
    largest = std::max(largest, here);
    counts[k] = sum;
    sum += here;
  }
  return largest;
}

}  // namespace

void PairOrder::ascend(hg_pair *pairs, size_t count, size_t slots, int32_t base) {
  if (count > most_counted_ || (slots > kInCache && is_scattered(pairs, count))) {
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
  for (size_t p = 0; p < all.count; p++) next[distance(all.base, all.pairs[p].a) / kBucket]++;
  counts_to_begins(next, buckets);
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
  for (size_t p = 0; p < run.count; p++) next[distance(run.first_id, run.pairs[p].a)]++;
  const uint32_t longest = counts_to_begins(next, run.slots);
  for (size_t p = 0; p < run.count; p++) {
    partners[next[distance(run.first_id, run.pairs[p].a)]++] = distance(run.base, run.pairs[p].b);
  }
  if (longest <= kMostSorted) return;
  uint32_t begin = 0;
  for (size_t row = 0; row < run.slots; row++) {
    if (next[row] - begin > kMostSorted) std::sort(partners + begin, partners + next[row]);
    begin = next[row];
  }
}

}  // namespace hg
