// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/query_rows.hpp"

#include "src/base/error.hpp"
#include "src/base/parallel.hpp"
#include "src/base/radix_sort.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace hg {
namespace {

constexpr size_t kTaskQueries = 256;
constexpr int kPlaceBits = 10;  // of a place on each axis, as the order along space sees it

// The lowest kPlaceBits of n, two zeros after each.
uint32_t spread_bits(uint32_t n) {
  n = (n | n << 16) & 0x030000ffu;
  n = (n | n << 8) & 0x0300f00fu;
  n = (n | n << 4) & 0x030c30c3u;
  return (n | n << 2) & 0x09249249u;
}

// Along a Morton curve, as coarse as that is good enough to meet what is in cache.
uint32_t curve_of(const Index &index, double per_quantum, const double *center) {
  constexpr double kLast = (1 << kPlaceBits) - 1;
  double quanta[3] = {0, 0, 0};
  index.map.find_quanta(center, index.domain.dimension, quanta);
  uint32_t curve = 0;
  for (int axis = 0; axis < 3; axis++) {
    const double step = quanta[axis] * per_quantum;
    const double within = step > 0 ? std::min(step, kLast) : 0.0;  // also of no number
    curve |= spread_bits(static_cast<uint32_t>(within)) << axis;
  }
  return curve;
}

constexpr size_t kShortRow = 32;

// Each id goes to where as many are before it as are less: no branch depends on their order, which no predictor knows.
void ascend_short_row(int32_t *ids, size_t count) {
  constexpr size_t kAtOnce = 8;
  int32_t given[kShortRow];
  std::fill(given, given + kShortRow, std::numeric_limits<int32_t>::max());
  std::copy_n(ids, count, given);
  const size_t padded = (count + kAtOnce - 1) / kAtOnce * kAtOnce;
  for (size_t k = 0; k < count; k++) {
    int32_t before[kAtOnce] = {};
    for (size_t n = 0; n < padded; n += kAtOnce) {
      for (size_t lane = 0; lane < kAtOnce; lane++) before[lane] += given[n + lane] < given[k] ? 1 : 0;
    }
    ids[std::accumulate(before, before + kAtOnce, 0)] = given[k];
  }
}

// Numbers of queries in the lower halves.
const uint64_t *order_along_space(const BuiltGrid &grid, const RowSource &source, Buffer<uint64_t> &room) {
  const Index &index = grid.index;
  const size_t count = source.count();
  const double longest = *std::max_element(index.map.extent, index.map.extent + 3);
  const double per_quantum = longest > 0 ? (1 << kPlaceBits) / longest : 0;
  room.require_room(2 * count);
  each_part(grid.threads, count, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; k++) {
      double center[3] = {0, 0, 0};
      source.find_center(k, center);
      room[k] = uint64_t{curve_of(index, per_quantum, center)} << 32 | k;
    }
  });
  return radix_sort(room.data(), room.data() + count, count, 3 * kPlaceBits,
                    [](uint64_t entry) { return entry >> 32; });
}

}  // namespace

size_t ascend_row(Buffer<int32_t> &ids, size_t begin, size_t end, bool may_repeat) {
  int32_t *first = ids.data() + begin, *last = ids.data() + end;
  if (!may_repeat && end - begin <= kShortRow) {
    ascend_short_row(first, end - begin);
    return end;
  }
  std::sort(first, last);
  return static_cast<size_t>(std::unique(first, last) - ids.data());
}

void QueryRows::start(const BuiltGrid &grid, size_t count) {
  if (memory_.bytes() > kMostKept) {
    offsets_.release();
    ids_.release();
    order_.release();
    rows_.release();
    workers_.clear();
  }
  offsets_.require_room(count + 1);
  rows_.require_room(count);
  workers_.reserve(static_cast<size_t>(grid.threads));
  while (workers_.size() < static_cast<size_t>(grid.threads)) workers_.emplace_back(memory_);
  for (Worker &worker : workers_) worker.count = 0;
}

void QueryRows::find(const BuiltGrid &grid, const RowSource &source) {
  const size_t count = source.count();
  if (count > std::numeric_limits<int32_t>::max()) fail(HG_ERR_LIMIT, "count = %zu: more than 2^31 - 1 queries", count);
  start(grid, count);
  const uint64_t *order = order_along_space(grid, source, order_);
  parallel_for(grid.threads, (count + kTaskQueries - 1) / kTaskQueries, [&](size_t task, int worker) {
    Worker &mine = workers_[static_cast<size_t>(worker)];
    const size_t end = std::min(count, (task + 1) * kTaskQueries);
    for (size_t n = task * kTaskQueries; n < end; n++) {
      const size_t k = order[n] & UINT32_MAX, begin = mine.count;
      mine.count = source.find(k, mine.ids, begin);
      rows_[k] = {begin, worker};
      offsets_[k + 1] = static_cast<int64_t>(mine.count - begin);
    }
  });

  offsets_[0] = 0;
  for (size_t k = 0; k < count; k++) offsets_[k + 1] += offsets_[k];
  ids_.require_room(static_cast<size_t>(offsets_[count]));
  each_part(grid.threads, count, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; k++) {
      const int32_t *row = workers_[static_cast<size_t>(rows_[k].worker)].ids.data() + rows_[k].begin;
      std::copy_n(row, offsets_[k + 1] - offsets_[k], ids_.data() + offsets_[k]);
    }
  });
}

}  // namespace hg
