// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the particles of stored candidates are now, and whether any has moved too far; one source for all instruction
// sets. Plain loops over blocks, as in build.hpp.
#pragma once

#include "src/kernels/kernel_set.hpp"
#include "src/kernels/wrap.hpp"

#include <cmath>

namespace hg {
namespace {

constexpr size_t kUpdateBlock = 64;
constexpr size_t kFetchAhead = 48;  // points whose centres are on their way from memory

// Coordinates are cut off there: beyond, a particle is farther from any place in the frame than a skin reaches.
constexpr double kLow = -0x1p29, kSpan = 0x1p31 - 1;

// Places likewise. A multiple of 2^32, so that adding it leaves coordinates what they are.
constexpr double kFarthest = 0x1p47;

// How far two conversions of a radius to float may be off, relative to it; docs/theory/exactness.md.
constexpr float kGrowthError = 0x1p-21f;

template <int D>
class UpdateBlock {
 public:
  explicit UpdateBlock(const UpdateInput &input) : input_(input) {}

  // What is left of the room, as an UpdateKernel tells it.
  float run(size_t at, size_t end, Point *points) {
    const size_t count = end - at < kUpdateBlock ? end - at : kUpdateBlock;
    load(at, count, end);
    for (float &d2 : moved2_) d2 = 0;
    wrap_from<D>(0, position_, input_.map, input_.extent);
    if (input_.place[0] == nullptr && !input_.map.tilted) {
      for (int axis = 0; axis < D; axis++) update_axis(axis);
    } else {
      update_places(at, count);
    }
    for (float &room : room_) room = input_.room;
    if (input_.radii != nullptr) grow();
    int32_t beyond = 0;
    for (size_t i = 0; i < kUpdateBlock; i++) beyond |= moved2_[i] <= room_[i] * room_[i] ? 0 : 1;
    for (const float room : room_) beyond |= room >= 0.0f ? 0 : 1;
    for (size_t i = 0; points != nullptr && i < count; i++) {
      Point &point = points[at + i];
      point.x = fixed_[0][i];
      point.y = fixed_[1][i];
      point.z = D == 3 ? fixed_[2][i] : 0;
      if (input_.radii != nullptr) point.radius = folded_[i];
    }
    return beyond == 0 ? least_left() : -1.0f;
  }

 private:
  // Of all, the least room, less the longest way: not more than what is left to any.
  float least_left() const {
    float least = room_[0], longest2 = 0;
    for (const float room : room_) least = room < least ? room : least;
    for (const float d2 : moved2_) longest2 = d2 > longest2 ? d2 : longest2;
    const float left = least - std::sqrt(longest2);
    return left > 0.0f ? left : 0.0f;
  }

  // A block that is not full repeats its first particle.
  void load(size_t at, size_t count, size_t end) {
    for (size_t i = 0; i < kUpdateBlock; i++) {
      if (at + i + kFetchAhead < end) fetch(at + i + kFetchAhead);
      load_one(i, at + (i < count ? i : 0));
    }
    for (int axis = 0; axis < D; axis++) {
      start_[axis] = input_.x[axis] + at;
      if (count == kUpdateBlock) continue;
      for (size_t i = 0; i < kUpdateBlock; i++) start_copy_[axis][i] = start_[axis][i < count ? i : 0];
      start_[axis] = start_copy_[axis];
    }
  }

  void fetch(size_t from) { __builtin_prefetch(input_.centers + static_cast<size_t>(input_.slot[from]) * D); }

  void load_one(size_t i, size_t from) {
    const size_t slot = input_.slot[from];
    for (size_t axis = 0; axis < D; axis++) position_[axis][i] = input_.centers[slot * D + axis];
    if (input_.radii == nullptr) return;
    radius_[i] = input_.radii[slot];
    start_radius_[i] = input_.radius[from];
  }

  // FixedPoint::find_coordinates, but on open axes particles may leave the frame, and on periodic ones they keep to the
  // image that is nearest to where they were.
  void update_axis(int axis) {
    const double(&position)[kUpdateBlock] = position_[axis];
    int32_t *__restrict fixed = fixed_[axis];
    const int32_t *__restrict start = start_[axis];
    float *__restrict moved2 = moved2_;
    const double scale = input_.map.scale, half_origin = input_.map.half_origin[axis];
    for (size_t i = 0; i < kUpdateBlock; i++) {
      fixed[i] = floor_within(to_quanta(position[i], half_origin, scale), kLow, kSpan);
    }
    if (input_.map.length[axis] > 0) {
      const int32_t period = input_.map.period[axis], half = period / 2;
      for (size_t i = 0; i < kUpdateBlock; i++) {
        const int32_t moved = fixed[i] - start[i];
        fixed[i] += moved > half ? -period : (moved < -half ? period : 0);
      }
    }
    for (size_t i = 0; i < kUpdateBlock; i++) {
      const float moved = static_cast<float>(fixed[i] - start[i]);
      moved2[i] += moved * moved;
    }
  }

  // The same in doubles: where coordinates wrap and so do not tell how far a particle has moved, and where whole edges
  // of a tilted cell lead back to the nearest image.
  __attribute__((noinline)) void update_places(size_t at, size_t count) {
    const FixedPoint &map = input_.map;
    for (int axis = D - 1; axis >= 0; axis--) {
      double(&position)[kUpdateBlock] = position_[axis];
      const double scale = map.scale, half_origin = map.half_origin[axis];
      for (double &place : position) {
        const double quanta = to_quanta(place, half_origin, scale);
        place = quanta > -kFarthest ? (quanta < kFarthest ? quanta : kFarthest) : -kFarthest;
      }
      double start[kUpdateBlock];
      for (size_t i = 0; i < kUpdateBlock; i++) start[i] = start_place(axis, i, at + (i < count ? i : 0));
      if (map.length[axis] > 0) lead_back(axis, start);
      if (input_.place[axis] != nullptr) {
        for (size_t i = 0; i < kUpdateBlock; i++) fixed_[axis][i] = low_word(to_whole(position[i] + kFarthest));
      } else {
        for (size_t i = 0; i < kUpdateBlock; i++) fixed_[axis][i] = floor_within(position[i], kLow, kSpan);
        for (size_t i = 0; i < kUpdateBlock; i++) position[i] = fixed_[axis][i];
      }
      for (size_t i = 0; i < kUpdateBlock; i++) {
        const float moved = static_cast<float>(position[i] - start[i]);
        moved2_[i] += moved * moved;
      }
    }
  }

  double start_place(int axis, size_t i, size_t point) const {
    return input_.place[axis] != nullptr ? input_.place[axis][point] : start_[axis][i];
  }

  // By whole edges, the last first.
  void lead_back(int axis, const double (&start)[kUpdateBlock]) {
    const FixedPoint &map = input_.map;
    double(&position)[kUpdateBlock] = position_[axis];
    for (int higher = D - 1; higher > axis && map.tilted; higher--) {
      const double tilt = map.tilt[kTiltOf[higher][axis]] * map.scale;
      for (size_t i = 0; i < kUpdateBlock; i++) position[i] += edges_[higher][i] * tilt;
    }
    const double period = map.tilted ? map.length[axis] * map.scale : map.period_place(axis);
    for (size_t i = 0; i < kUpdateBlock; i++) {
      edges_[axis][i] =
          map.tilted ? edges_back(position[i] - start[i], period) : boxes_back(position[i] - start[i], period);
      position[i] += period * edges_[axis][i];
    }
  }

  // Growth counts as motion; what shrinks stays a candidate.
  void grow() {
    for (size_t i = 0; i < kUpdateBlock; i++) {
      folded_[i] = static_cast<float>((radius_[i] + input_.extra_radius) * input_.map.scale);
    }
    for (size_t i = 0; i < kUpdateBlock; i++) {
      const float wide = static_cast<float>((radius_[i] + input_.extra_wide_radius) * input_.map.scale);
      const float growth = wide - start_radius_[i];
      room_[i] -= (growth > 0.0f ? growth : 0.0f) + kGrowthError * wide;
    }
  }

  const UpdateInput &input_;
  alignas(64) double position_[3][kUpdateBlock];
  alignas(64) double edges_[3][kUpdateBlock] = {};  // that lead back
  alignas(64) double radius_[kUpdateBlock];
  const int32_t *start_[3];
  alignas(64) int32_t start_copy_[3][kUpdateBlock];
  alignas(64) int32_t fixed_[3][kUpdateBlock];
  alignas(64) float start_radius_[kUpdateBlock];
  alignas(64) float folded_[kUpdateBlock];
  alignas(64) float moved2_[kUpdateBlock];
  alignas(64) float room_[kUpdateBlock];
};

template <int D>
float update(const UpdateInput &input, size_t begin, size_t end, Point *points) {
  UpdateBlock<D> block(input);
  float least = input.room;
  for (size_t at = begin; at < end; at += kUpdateBlock) {
    const float left = block.run(at, end, points);
    if (left < 0.0f) return left;
    least = left < least ? left : least;
  }
  return least;
}

}  // namespace
}  // namespace hg
