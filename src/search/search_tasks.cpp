// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/search_tasks.hpp"

#include "src/kernels/kernel_set.hpp"

#include <algorithm>

namespace hg {
namespace {

constexpr double kTaskRows = 16384;  // rows of cells that a task visits, about

// How many rows of level k a particle of level h visits.
double rows_visited(const Index &index, int h, int k) {
  const IndexLevel &level = index.levels[h], &target = index.levels[k];
  const double reach = static_cast<double>(level.cells.largest_radius) + target.cells.largest_radius;
  double rows = 1;
  for (int axis = 1; axis < index.domain.dimension; axis++) {
    if (index.chunked) {
      rows *= 2 * reach / index.chunks.level(k).row_width + 1.0;
      continue;
    }
    rows *= std::min(2 * reach / static_cast<double>(target.cells.width[axis]) + 1.0,
                     static_cast<double>(target.cells.count[axis]));
  }
  return rows;
}

}  // namespace

void SearchTasks::add(const Index &index, int level, int target, bool images, uint32_t begin, uint32_t end) {
  const double rows = rows_visited(index, level, target);
  const double wanted = std::clamp(kTaskRows / rows, 1.0, kTaskRows);
  const uint32_t step = (static_cast<uint32_t>(wanted) + kBlock - 1) / kBlock * kBlock;
  while (begin < end) {
    const uint32_t stop = end - begin > step ? begin + step : end;
    tasks_.grow(count_ + 1);
    tasks_[count_++] = {level, target, images, begin, stop};
    begin = stop;
  }
}

void SearchTasks::list(const Index &index) {
  count_ = 0;
  // Coarse levels first: their tasks are the longest.
  for (int h = index.level_count - 1; h >= 0; h--) {
    const IndexLevel &level = index.levels[h];
    if (level.is_empty()) continue;
    for (int target = index.level_number(level.insertion_level + 1, 0) - 1; target >= 0; target--) {
      if (!index.searches(h, target)) continue;
      add(index, h, target, false, level.begin, level.end);
      add(index, h, target, true, level.image_begin, target == h ? level.image_forward_end : level.image_end);
    }
  }
}

}  // namespace hg
