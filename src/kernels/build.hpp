// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The three passes of building, one source for all instruction sets: find the row of each particle, then put it there
// in fixed point, then sort each row by cells. The second pass makes the coordinates anew, which is cheaper than
// keeping them between. Plain loops over blocks that the compiler turns into vector code of the file's instruction set.
#pragma once

#include "src/kernels/choose_levels.hpp"
#include "src/kernels/kernel_set.hpp"
#include "src/kernels/lanes_scalar.hpp"
#include "src/kernels/wrap.hpp"

#include <cmath>
#include <cstring>

namespace hg {
namespace {

// More than 16, which the compiler would unroll before it could use vectors.
constexpr size_t kBuildBlock = 64;

template <int D>
class BuildBlock {
 public:
  explicit BuildBlock(const BuildInput &input) : input_(input) {}

  void find_rows(size_t at, size_t count, const RowCount &output) {
    load(at, count);
    fix_from(1);
    find_rows();
    for (size_t i = 0; i < count; i++) {
      output.row_of[at + i] = row_[i];
      output.row_count[row_[i]]++;
    }
  }

  void put_into_rows(size_t at, size_t count, const RowScatter &output) {
    // The rows' ends are more cache lines than the nearest cache has: ask for all of them before the first is made.
    RowParticle *to[kBuildBlock];
    for (size_t i = 0; i < count; i++) {
      to[i] = output.particles + output.row_next[output.row_of[at + i]]++;
      __builtin_prefetch(to[i], 1);
    }
    load(at, count);
    fix_from(0);
    fold();
    Point point[kBuildBlock];
    for (size_t i = 0; i < kBuildBlock; i++) {
      point[i] = {fixed_[0][i], fixed_[1][i], D == 3 ? fixed_[2][i] : 0, folded_[i]};
    }
    const uint32_t *slots = input_.slots;
    for (size_t i = 0; i < count; i++) {
      std::memcpy(to[i], point + i, sizeof(Point));
      to[i]->slot = slots != nullptr ? slots[at + i] : static_cast<uint32_t>(at + i);
    }
  }

 private:
  void load(size_t at, size_t count) {
    const double *centers = input_.centers + at * D;
    if (count == kBuildBlock) {
      for (size_t i = 0; i < kBuildBlock; i++) {
        for (size_t axis = 0; axis < D; axis++) position_[axis][i] = centers[i * D + axis];
        radius_[i] = input_.radii[at + i];
      }
      return;
    }
    for (size_t i = 0; i < kBuildBlock; i++) {
      const size_t from = i < count ? i : 0;
      for (size_t axis = 0; axis < D; axis++) position_[axis][i] = centers[from * D + axis];
      radius_[i] = input_.radii[at + from];
    }
  }

  // FixedPoint::find_coordinates, on a block.
  void fix_from(int first) {
    wrap_from<D>(first, position_, input_.map, input_.extent);
    for (int axis = first; axis < D; axis++) {
      const double scale = input_.map.scale, half_origin = input_.map.half_origin[axis];
      for (size_t i = 0; i < kBuildBlock; i++) {
        fixed_[axis][i] = floor_within(to_quanta(position_[axis][i], half_origin, scale), 0, kFixedPointQuanta - 1);
      }
    }
  }

  void fold() {
    for (size_t i = 0; i < kBuildBlock; i++) {
      folded_[i] = static_cast<float>((radius_[i] + input_.extra_radius) * input_.map.scale);
    }
  }

  // Eq. 2, but for x: the level of insertion h(p), the finest that takes the radius (Eq. 3), picks the widths of the
  // cells, M(x, h) the row in y and z (Eq. 1). Rows are numbered through all levels.
  void find_rows() {
    float inverse_y[kBuildBlock], last_y[kBuildBlock], inverse_z[kBuildBlock], last_z[kBuildBlock];
    uint32_t count_y[kBuildBlock], base[kBuildBlock];
    choose_levels(radius_, input_.levels, input_.level_count, [&](size_t i, const LevelRows &level, bool yes) {
      take_if(yes, inverse_y[i], level.inverse_y);
      take_if(yes, last_y[i], level.last_y);
      take_if(yes, inverse_z[i], level.inverse_z);
      take_if(yes, last_z[i], level.last_z);
      take_if(yes, count_y[i], level.count_y);
      take_if(yes, base[i], level.row_base);
    });
    for (size_t i = 0; i < kBuildBlock; i++) {
      const uint32_t y = row_along(fixed_[1][i], inverse_y[i], last_y[i]);
      const uint32_t z = D == 3 ? row_along(fixed_[2][i], inverse_z[i], last_z[i]) : 0;
      row_[i] = base[i] + z * count_y[i] + y;
    }
  }

  static uint32_t row_along(int32_t x, float inverse, float last) {
    return static_cast<uint32_t>(cell_of<ScalarLanes>(static_cast<float>(x), inverse, last));
  }

  const BuildInput &input_;
  alignas(64) double position_[3][kBuildBlock];
  alignas(64) double radius_[kBuildBlock];
  alignas(64) int32_t fixed_[3][kBuildBlock];
  alignas(64) float folded_[kBuildBlock];
  alignas(64) uint32_t row_[kBuildBlock];
};

template <int D>
void find_rows(const BuildInput &input, size_t begin, size_t end, const RowCount &output) {
  BuildBlock<D> block(input);
  for (size_t at = begin; at < end; at += kBuildBlock) {
    block.find_rows(at, end - at < kBuildBlock ? end - at : kBuildBlock, output);
  }
}

template <int D>
void put_into_rows(const BuildInput &input, size_t begin, size_t end, const RowScatter &output) {
  BuildBlock<D> block(input);
  for (size_t at = begin; at < end; at += kBuildBlock) {
    block.put_into_rows(at, end - at < kBuildBlock ? end - at : kBuildBlock, output);
  }
}

// Counting sort of one row by cell, stable; fills the row's part of the table. `cell`: room for the cell of each.
template <int D>
void sort_row(const RowSort &rows, uint32_t begin, size_t count, uint32_t *cells, uint32_t *cell) {
  const auto cell_count = static_cast<size_t>(rows.row_cells);
  if (count == 0) {
    for (size_t c = 0; c < cell_count; c++) cells[c] = begin;
    return;
  }
  for (size_t c = 0; c < cell_count; c++) cells[c] = 0;
  const RowParticle *from = rows.particles + begin;
  for (size_t i = 0; i < count; i++) {
    const auto x = static_cast<float>(from[i].x);
    const auto c = static_cast<uint32_t>(cell_of<ScalarLanes>(x, rows.inverse_width, rows.last));
    cell[i] = c;
    cells[c]++;
  }
  uint32_t sum = begin;
  for (size_t c = 0; c < cell_count; c++) cells[c] = sum += cells[c];
  for (size_t i = count; i-- > 0;) {
    const uint32_t to = --cells[cell[i]];
    rows.output.x[to] = from[i].x;
    rows.output.y[to] = from[i].y;
    if constexpr (D == 3) rows.output.z[to] = from[i].z;
    rows.output.radius[to] = from[i].radius;
    rows.output.slot[to] = from[i].slot;
  }
}

template <int D>
void sort_rows(const RowSort &rows, size_t begin, size_t end, uint32_t *room) {
  for (size_t row = begin; row < end; row++) {
    const uint32_t first = rows.row_begin[row];
    sort_row<D>(rows, first, rows.row_begin[row + 1] - first,
                rows.cell_begin + row * static_cast<size_t>(rows.row_cells), room);
  }
}

template <int D>
constexpr BuildKernel make_build() {
  return {find_rows<D>, put_into_rows<D>, sort_rows<D>};
}

}  // namespace
}  // namespace hg
