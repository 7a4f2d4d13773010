// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/pairs/neighbor_rows.hpp"

#include <algorithm>
#include <cstring>

namespace hg {
namespace {

// Rows of contacts are short: insertion beats std::sort there.
void sort_row(int32_t *begin, int32_t *end) {
  if (end - begin > 32) {
    std::sort(begin, end);
    return;
  }
  for (int32_t *p = begin + 1; p < end; p++) {
    const int32_t value = *p;
    int32_t *q = p;
    for (; q > begin && q[-1] > value; q--) *q = q[-1];
    *q = value;
  }
}

// The half list of ascending pairs: their second particles as they stand.
void cut_into_rows(const hg_pair *pairs, size_t pair_count, size_t row_count, int32_t base, int64_t *offset,
                   int32_t *neighbors) {
  size_t p = 0;
  for (size_t row = 0; row < row_count; row++) {
    offset[row] = static_cast<int64_t>(p);
    const int32_t a = static_cast<int32_t>(row) + base;
    for (; p < pair_count && pairs[p].a == a; p++) neighbors[p] = pairs[p].b;
  }
  offset[row_count] = static_cast<int64_t>(p);
}

}  // namespace

void NeighborRows::build(const hg_pair *pairs, size_t pair_count, size_t row_count, int32_t base, int32_t list,
                         bool ascending) {
  const bool full = list == HG_FULL;
  offsets_.require(row_count + 1);
  neighbors_.require_room(std::max<size_t>(1, full ? 2 * pair_count : pair_count));
  int64_t *offset = offsets_.data();
  if (ascending && !full) {
    cut_into_rows(pairs, pair_count, row_count, base, offset, neighbors_.data());
    return;
  }
  std::fill(offset, offset + row_count + 1, int64_t{0});
  for (size_t p = 0; p < pair_count; p++) {
    offset[pairs[p].a - base]++;
    if (full) offset[pairs[p].b - base]++;
  }
  int64_t sum = 0;
  for (size_t row = 0; row <= row_count; row++) {
    const int64_t here = offset[row];
    offset[row] = sum;
    sum += here;
  }
  for (size_t p = 0; p < pair_count; p++) {
    neighbors_[static_cast<size_t>(offset[pairs[p].a - base]++)] = pairs[p].b;
    if (full) neighbors_[static_cast<size_t>(offset[pairs[p].b - base]++)] = pairs[p].a;
  }
  // Each offset has moved to where the next row begins.
  std::memmove(offset + 1, offset, row_count * sizeof *offset);
  offset[0] = 0;
  for (size_t row = 0; row < row_count; row++) {
    sort_row(neighbors_.data() + offset[row], neighbors_.data() + offset[row + 1]);
  }
}

}  // namespace hg
