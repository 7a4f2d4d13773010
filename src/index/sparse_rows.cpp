// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/index/sparse_rows.hpp"

#include <algorithm>
#include <cmath>

namespace hg {

int64_t SparseLevel::row_of(int axis, double position) const {
  constexpr double kFarthest = 0x1p62;
  return static_cast<int64_t>(std::floor(std::clamp((position - origin[axis]) / width, -kFarthest, kFarthest)));
}

SparseLevel SparseRows::add_level(const ParticleStore &store, const Domain &domain, const double *origin, double width,
                                  uint32_t *slots, uint32_t begin, uint32_t count) {
  SparseLevel level;
  level.width = width;
  for (int axis = 0; axis < domain.dimension; axis++) level.origin[axis] = origin[axis];
  level.begin = begin;
  level.end = begin + count;
  level.offset = particles_;
  level.first_slab = slabs_;

  order_.require(count);
  for (uint32_t i = 0; i < count; i++) {
    const double *center = store.center(slots[i]);
    order_[i].x = domain.position(0, center[0]);
    order_[i].y = level.row_of(1, domain.position(1, center[1]));
    order_[i].z = domain.dimension == 3 ? level.row_of(2, domain.position(2, center[2])) : 0;
    order_[i].slot = slots[i];
  }
  std::sort(order_.data(), order_.data() + count, [](const Key &a, const Key &b) {
    if (a.z != b.z) return a.z < b.z;
    if (a.y != b.y) return a.y < b.y;
    if (a.x != b.x) return a.x < b.x;
    return a.slot < b.slot;
  });

  // Each level closes with an end mark in row_begin_ and slab_row_, as the next level may begin elsewhere.
  x_.grow(particles_ + count);
  row_y_.grow(rows_ + count + 1);
  row_begin_.grow(rows_ + count + 1);
  slab_z_.grow(slabs_ + count + 1);
  slab_row_.grow(slabs_ + count + 1);
  for (uint32_t i = 0; i < count; i++) {
    const Key &key = order_[i];
    const bool new_slab = i == 0 || key.z != order_[i - 1].z;
    if (new_slab) {
      slab_z_[slabs_] = key.z;
      slab_row_[slabs_++] = rows_;
    }
    if (new_slab || key.y != order_[i - 1].y) {
      row_y_[rows_] = key.y;
      row_begin_[rows_++] = begin + i;
    }
    x_[particles_ + i] = key.x;
    slots[i] = key.slot;
  }
  particles_ += count;
  level.end_slab = slabs_;
  slab_row_[slabs_++] = rows_;
  row_begin_[rows_++] = level.end;
  return level;
}

SparseRows::Place SparseRows::place_of(const SparseLevel &level, uint32_t i) const {
  const uint32_t *rows = row_begin_.data();
  const uint32_t *row = std::upper_bound(rows + slab_row_[level.first_slab], rows + slab_row_[level.end_slab], i) - 1;
  const auto row_index = static_cast<size_t>(row - rows);
  const size_t *slabs = slab_row_.data();
  const size_t *slab = std::upper_bound(slabs + level.first_slab, slabs + level.end_slab, row_index) - 1;
  return {static_cast<size_t>(slab - slabs), row_index};
}

size_t SparseRows::lower_slab(const SparseLevel &level, int64_t z) const {
  const int64_t *first = slab_z_.data() + level.first_slab, *last = slab_z_.data() + level.end_slab;
  return static_cast<size_t>(std::lower_bound(first, last, z) - slab_z_.data());
}

size_t SparseRows::lower_row(size_t slab, int64_t y) const {
  const int64_t *first = row_y_.data() + slab_row_[slab], *last = row_y_.data() + slab_row_[slab + 1];
  return static_cast<size_t>(std::lower_bound(first, last, y) - row_y_.data());
}

uint32_t SparseRows::lower_particle(const SparseLevel &level, size_t row, double x) const {
  const double *positions = x_.data() + level.offset;
  const double *found =
      std::lower_bound(positions + (row_begin_[row] - level.begin), positions + (row_begin_[row + 1] - level.begin), x);
  return level.begin + static_cast<uint32_t>(found - positions);
}

uint32_t SparseRows::upper_particle(const SparseLevel &level, size_t row, double x) const {
  const double *positions = x_.data() + level.offset;
  const double *found =
      std::upper_bound(positions + (row_begin_[row] - level.begin), positions + (row_begin_[row + 1] - level.begin), x);
  return level.begin + static_cast<uint32_t>(found - positions);
}

}  // namespace hg
