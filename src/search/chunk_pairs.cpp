// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/chunk_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace hg {
namespace {

// The points of one chunk share a list of what is near them, unless their cells are so many times wider than what
// they search: then each alone meets much less.
constexpr double kSharedWidth = 4;

}  // namespace

ChunkPairs::ChunkPairs(const Index &index, const PointArrays &points, const PointArrays &particles, PairStream &stream)
    : index_(index),
      points_(points),
      particles_(particles),
      stream_(stream),
      kernel_(active_kernels().chunk_search[index.domain.dimension - 2][index.interaction.kind]) {}

bool ChunkPairs::run(const SearchTask &task) {
  const ChunkTable table = index_.chunk_table(task.target);
  if (task.level == task.target && !task.images) {
    return kernel_.own_level(points_, task.begin, task.end, table, &stream_);
  }
  Searchers searchers{};
  for (uint32_t i = task.begin; i < task.end; i = searchers.points.end) {
    if (task.images) {
      gather_images(task, i, searchers);
    } else {
      gather_particles(task, i, searchers);
    }
    set_box(task, searchers);
    if (!search(task, table, searchers)) return false;
  }
  return true;
}

bool ChunkPairs::search_together(const SearchTask &task) const {
  return index_.chunks.level(task.level).cell <= kSharedWidth * index_.chunks.level(task.target).cell;
}

void ChunkPairs::gather_particles(const SearchTask &task, uint32_t begin, Searchers &searchers) const {
  const ChunkRows &chunks = index_.chunks;
  const size_t chunk = chunks.chunk_of(begin);
  double corner[3];
  chunks.find_corner(chunks.level(task.level), chunk, corner);
  chunks.find_place(points_, begin, chunk, corner, index_.domain.dimension, searchers.place);
  searchers.points.begin = begin;
  searchers.points.end = search_together(task) ? std::min(task.end, chunks.chunk_end(chunk)) : begin + 1;
}

// Those that follow by the same step and are no farther from the first than a chunk is long.
void ChunkPairs::gather_images(const SearchTask &task, uint32_t begin, Searchers &searchers) const {
  const double farthest = index_.chunks.level(task.level).chunk_length();
  const auto is_near = [&](uint32_t i) {
    if (points_.image[i] != points_.image[begin]) return false;
    for (int axis = 0; axis < index_.domain.dimension; axis++) {
      if (std::fabs(index_.image_place[axis][i] - index_.image_place[axis][begin]) > farthest) return false;
    }
    return true;
  };
  for (int axis = 0; axis < index_.domain.dimension; axis++) searchers.place[axis] = index_.image_place[axis][begin];
  searchers.points.begin = begin;
  searchers.points.end = begin + 1;
  if (!search_together(task)) return;
  while (searchers.points.end < task.end && is_near(searchers.points.end)) searchers.points.end++;
}

void ChunkPairs::set_box(const SearchTask &task, Searchers &searchers) const {
  ChunkGroup &group = searchers.points;
  const float largest = *std::max_element(points_.radius + group.begin, points_.radius + group.end);
  const double base = index_.interaction.with_rule([&](auto rule) {
    return rule.base(static_cast<double>(largest),
                     static_cast<double>(index_.levels[task.target].cells.largest_radius));
  });
  const double reach = base * static_cast<double>(kSearchScale);
  for (int axis = 0; axis < index_.domain.dimension; axis++) {
    const int32_t *x = coordinates(points_, axis);
    int32_t least = 0, most = 0;
    group.place[axis] = x[group.begin];
    for (uint32_t i = group.begin; i < group.end; i++) {
      const int32_t offset = near_difference(x[i], group.place[axis]);
      least = std::min(least, offset);
      most = std::max(most, offset);
    }
    searchers.box.low[axis] = searchers.place[axis] + least - reach;
    searchers.box.high[axis] = searchers.place[axis] + most + reach;
  }
}

bool ChunkPairs::search(const SearchTask &task, const ChunkTable &table, const Searchers &searchers) {
  NearChunks near;
  near.count = 0;
  const auto send = [&] {
    const bool go_on = kernel_.near_chunks(points_, searchers.points, table, near, particles_, &stream_);
    near.count = 0;
    return go_on;
  };
  const auto list = [&](size_t chunk, const double *corner) {
    if (near.count == NearChunks::kMost && !send()) return false;
    const uint32_t at = near.count++;
    near.x[at] = static_cast<float>(corner[0] - searchers.place[0]);
    near.y[at] = static_cast<float>(corner[1] - searchers.place[1]);
    near.z[at] = static_cast<float>(corner[2] - searchers.place[2]);
    near.cell[at] = index_.chunks.chunk_cell(chunk);
    return true;
  };
  return index_.chunks.visit_box(index_.chunks.level(task.target), searchers.box, list) && (near.count == 0 || send());
}

}  // namespace hg
