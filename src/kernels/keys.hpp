// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The two passes of building over the caller's particles, one source for all instruction sets: find the row of each
// particle, then put it there in fixed point. The second pass makes the coordinates anew, which is cheaper than keeping
// them between. Plain loops over blocks that the compiler turns into vector code of the file's instruction set.
#pragma once

#include "src/kernels/kernel.hpp"

#include <cmath>

namespace hg {
namespace {

// More than 16, which the compiler would unroll before it could use vectors.
constexpr size_t kKeyBlock = 64;

template <int D>
class KeyBlock {
 public:
  explicit KeyBlock(const KeyInput &input) : input_(input) {}

  void find_rows(size_t at, size_t count, const RowCount &output) {
    load(at, count);
    for (int k = 1; k < D; k++) fix(k);
    find_rows();
    for (size_t i = 0; i < count; i++) {
      output.row_of[at + i] = row_[i];
      output.row_count[row_[i]]++;
    }
  }

  void put_into_rows(size_t at, size_t count, const RowScatter &output) {
    load(at, count);
    for (int k = 0; k < D; k++) fix(k);
    fold();
    // The rows' ends are more cache lines than the nearest cache has: ask for all of them before the first is written.
    uint32_t *to = row_;
    for (size_t i = 0; i < count; i++) {
      to[i] = output.row_next[output.row_of[at + i]]++;
      __builtin_prefetch(output.x + to[i], 1);
      __builtin_prefetch(output.y + to[i], 1);
      if constexpr (D == 3) __builtin_prefetch(output.z + to[i], 1);
      __builtin_prefetch(output.radius + to[i], 1);
      __builtin_prefetch(output.slot + to[i], 1);
    }
    for (size_t i = 0; i < count; i++) output.x[to[i]] = fixed_[0][i];
    for (size_t i = 0; i < count; i++) output.y[to[i]] = fixed_[1][i];
    if constexpr (D == 3) {
      for (size_t i = 0; i < count; i++) output.z[to[i]] = fixed_[2][i];
    }
    for (size_t i = 0; i < count; i++) output.radius[to[i]] = folded_[i];
    for (size_t i = 0; i < count; i++) output.slot[to[i]] = static_cast<uint32_t>(at + i);
  }

 private:
  void load(size_t at, size_t count) {
    const double *centers = input_.centers + at * D;
    if (count == kKeyBlock) {
      for (size_t i = 0; i < kKeyBlock; i++) {
        for (int k = 0; k < D; k++) position_[k][i] = centers[i * D + static_cast<size_t>(k)];
        radius_[i] = input_.radii[at + i];
      }
      return;
    }
    for (size_t i = 0; i < kKeyBlock; i++) {
      const size_t from = i < count ? i : 0;
      for (int k = 0; k < D; k++) position_[k][i] = centers[from * D + static_cast<size_t>(k)];
      radius_[i] = input_.radii[at + from];
    }
  }

  // Domain::position and Frame::coordinate, on a block.
  void fix(int axis) {
    double *x = position_[axis];
    const double twice_scale = 2 * input_.scale, half_origin = input_.half_origin[axis], top = input_.top;
    if (input_.length[axis] > 0) {
      const double low = input_.box_min[axis], length = input_.length[axis];
      for (size_t i = 0; i < kKeyBlock; i++) {
        const double above = x[i] - low;
        const double inside = above - std::floor(above / length) * length;
        x[i] = inside < 0 ? 0 : (inside > length ? length : inside);
      }
    }
    for (size_t i = 0; i < kKeyBlock; i++) {
      const double quanta = (0.5 * x[i] - half_origin) * twice_scale;
      const double positive = quanta > 0 ? quanta : 0.0;
      fixed_[axis][i] = static_cast<int32_t>(positive < top ? positive : top);
    }
  }

  void fold() {
    for (size_t i = 0; i < kKeyBlock; i++) {
      folded_[i] = static_cast<float>((radius_[i] + input_.extra_radius) * input_.scale);
    }
  }

  // The level of insertion (Eq. 3) picks the widths of cells; rows are numbered through all levels.
  void find_rows() {
    float inverse_y[kKeyBlock], last_y[kKeyBlock], inverse_z[kKeyBlock], last_z[kKeyBlock];
    uint32_t count_y[kKeyBlock], base[kKeyBlock];
    const KeyLevel &finest = input_.levels[0];
    for (size_t i = 0; i < kKeyBlock; i++) {
      inverse_y[i] = finest.inverse_y;
      last_y[i] = finest.last_y;
      inverse_z[i] = finest.inverse_z;
      last_z[i] = finest.last_z;
      count_y[i] = finest.count_y;
      base[i] = finest.row_base;
    }
    for (int h = 1; h < input_.level_count; h++) {
      const KeyLevel level = input_.levels[h];
      const double limit = input_.levels[h - 1].radius_limit;
      for (size_t i = 0; i < kKeyBlock; i++) {
        const bool coarser = radius_[i] > limit;
        inverse_y[i] = coarser ? level.inverse_y : inverse_y[i];
        last_y[i] = coarser ? level.last_y : last_y[i];
        inverse_z[i] = coarser ? level.inverse_z : inverse_z[i];
        last_z[i] = coarser ? level.last_z : last_z[i];
        count_y[i] = coarser ? level.count_y : count_y[i];
        base[i] = coarser ? level.row_base : base[i];
      }
    }
    for (size_t i = 0; i < kKeyBlock; i++) {
      const uint32_t y = cell(fixed_[1][i], inverse_y[i], last_y[i]);
      const uint32_t z = D == 3 ? cell(fixed_[2][i], inverse_z[i], last_z[i]) : 0;
      row_[i] = base[i] + z * count_y[i] + y;
    }
  }

  static uint32_t cell(int32_t x, float inverse, float last) {
    const float c = static_cast<float>(x) * inverse;
    const float positive = c > 0.0f ? c : 0.0f;
    return static_cast<uint32_t>(static_cast<int32_t>(positive < last ? positive : last));
  }

  const KeyInput &input_;
  alignas(64) double position_[3][kKeyBlock];
  alignas(64) double radius_[kKeyBlock];
  alignas(64) int32_t fixed_[3][kKeyBlock];
  alignas(64) float folded_[kKeyBlock];
  alignas(64) uint32_t row_[kKeyBlock];
};

template <int D>
void find_rows(const KeyInput &input, size_t begin, size_t end, const RowCount &output) {
  KeyBlock<D> block(input);
  for (size_t at = begin; at < end; at += kKeyBlock) {
    block.find_rows(at, end - at < kKeyBlock ? end - at : kKeyBlock, output);
  }
}

template <int D>
void put_into_rows(const KeyInput &input, size_t begin, size_t end, const RowScatter &output) {
  KeyBlock<D> block(input);
  for (size_t at = begin; at < end; at += kKeyBlock) {
    block.put_into_rows(at, end - at < kKeyBlock ? end - at : kKeyBlock, output);
  }
}

template <int D>
constexpr BuildKernel make_build() {
  return {find_rows<D>, put_into_rows<D>};
}

}  // namespace
}  // namespace hg
