// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the particles of stored candidates are now, and whether any has moved too far; one source for all instruction
// sets. Plain loops over blocks of 16, as in keys.hpp.
#pragma once

#include "src/kernels/kernel.hpp"

#include <cmath>

namespace hg {
namespace {

constexpr size_t kFollowBlock = 16;
constexpr size_t kFetchAhead = 48;  // points whose centres are on their way from memory

// Coordinates are cut off there: beyond, a particle is farther from any place in the frame than a skin reaches. Counted
// from the low end they are positive, so that cutting digits off rounds all of them down.
constexpr double kFollowLow = -0x1p29, kFollowTop = 0x1p31 - 1;

// How far two conversions of a radius to float may be off, relative to it; docs/exactness.md.
constexpr float kGrowthError = 0x1p-21f;

template <int D>
class FollowBlock {
 public:
  explicit FollowBlock(const FollowInput &input) : input_(input) {}

  // False if a particle has moved too far.
  bool run(size_t at, size_t count, Record *points) {
    load(at, count);
    for (float &d2 : moved2_) d2 = 0;
    for (int k = 0; k < D; k++) follow_axis(k);
    for (float &room : room_) room = input_.room;
    if (input_.radii != nullptr) grow();
    int32_t beyond = 0;
    for (size_t i = 0; i < kFollowBlock; i++) beyond |= moved2_[i] <= room_[i] * room_[i] ? 0 : 1;
    for (size_t i = 0; i < kFollowBlock; i++) beyond |= room_[i] >= 0.0f ? 0 : 1;
    for (size_t i = 0; i < count; i++) {
      Record &point = points[at + i];
      point.x = fixed_[0][i];
      point.y = fixed_[1][i];
      point.z = D == 3 ? fixed_[2][i] : 0;
      if (input_.radii != nullptr) point.radius = folded_[i];
    }
    return beyond == 0;
  }

 private:
  // A block that is not full repeats its first particle.
  void load(size_t at, size_t count) {
    if (count == kFollowBlock) {
      for (size_t i = 0; i < kFollowBlock; i++) load_one(i, at + i);
      for (int k = 0; k < D; k++) start_[k] = input_.x[k] + at;
      return;
    }
    for (size_t i = 0; i < kFollowBlock; i++) {
      const size_t from = at + (i < count ? i : 0);
      load_one(i, from);
      for (int k = 0; k < D; k++) start_copy_[k][i] = input_.x[k][from];
    }
    for (int k = 0; k < D; k++) start_[k] = start_copy_[k];
  }

  void load_one(size_t i, size_t from) {
    const size_t slot = input_.slot[from];
    for (int k = 0; k < D; k++) position_[k][i] = input_.centers[slot * D + static_cast<size_t>(k)];
    if (input_.radii == nullptr) return;
    radius_[i] = input_.radii[slot];
    start_radius_[i] = input_.radius[from];
  }

  // Frame::coordinate of Domain::position, but on open axes particles may leave the frame, and on periodic ones they
  // keep to the image that is nearest to where they were.
  void follow_axis(int axis) {
    double *__restrict x = position_[axis];
    int32_t *__restrict fixed = fixed_[axis];
    const int32_t *__restrict start = start_[axis];
    float *__restrict moved2 = moved2_;
    const double twice_scale = 2 * input_.scale, half_origin = input_.half_origin[axis];
    const bool periodic = input_.length[axis] > 0;
    if (periodic) {
      const double low = input_.box_min[axis], length = input_.length[axis];
      for (size_t i = 0; i < kFollowBlock; i++) {
        const double above = x[i] - low;
        const double inside = above - std::floor(above / length) * length;
        x[i] = inside < 0 ? 0 : (inside > length ? length : inside);
      }
    }
    for (size_t i = 0; i < kFollowBlock; i++) {
      const double quanta = (0.5 * x[i] - half_origin) * twice_scale - kFollowLow;
      const double positive = quanta > 0 ? quanta : 0.0;
      fixed[i] = static_cast<int32_t>(positive < kFollowTop ? positive : kFollowTop);
    }
    for (size_t i = 0; i < kFollowBlock; i++) fixed[i] += static_cast<int32_t>(kFollowLow);
    if (periodic) {
      const int32_t period = input_.period[axis], half = period / 2;
      for (size_t i = 0; i < kFollowBlock; i++) {
        const int32_t moved = fixed[i] - start[i];
        fixed[i] += moved > half ? -period : (moved < -half ? period : 0);
      }
    }
    for (size_t i = 0; i < kFollowBlock; i++) {
      const float moved = static_cast<float>(fixed[i] - start[i]);
      moved2[i] += moved * moved;
    }
  }

  // Growth counts as motion; what shrinks stays a candidate.
  void grow() {
    for (size_t i = 0; i < kFollowBlock; i++) {
      folded_[i] = static_cast<float>((radius_[i] + input_.extra_radius) * input_.scale);
    }
    for (size_t i = 0; i < kFollowBlock; i++) {
      const float wide = static_cast<float>((radius_[i] + input_.extra_wide_radius) * input_.scale);
      const float growth = wide - start_radius_[i];
      room_[i] -= (growth > 0.0f ? growth : 0.0f) + kGrowthError * wide;
    }
  }

  const FollowInput &input_;
  alignas(64) double position_[3][kFollowBlock];
  alignas(64) double radius_[kFollowBlock];
  const int32_t *start_[3];
  alignas(64) int32_t start_copy_[3][kFollowBlock];
  alignas(64) int32_t fixed_[3][kFollowBlock];
  alignas(64) float start_radius_[kFollowBlock];
  alignas(64) float folded_[kFollowBlock];
  alignas(64) float moved2_[kFollowBlock];
  alignas(64) float room_[kFollowBlock];
};

template <int D>
bool follow(const FollowInput &input, size_t begin, size_t end, Record *points) {
  FollowBlock<D> block(input);
  for (size_t at = begin; at < end; at += kFollowBlock) {
    if (at + kFetchAhead + kFollowBlock <= end) {
      const uint32_t *ahead = input.slot + at + kFetchAhead;
      for (size_t i = 0; i < kFollowBlock; i++) __builtin_prefetch(input.centers + static_cast<size_t>(ahead[i]) * D);
    }
    if (!block.run(at, end - at < kFollowBlock ? end - at : kFollowBlock, points)) return false;
  }
  return true;
}

}  // namespace
}  // namespace hg
