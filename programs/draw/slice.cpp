// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/draw/slice.hpp"

#include <algorithm>
#include <cmath>

namespace draw {
namespace {

struct Range {
  double low = 0, high = 0;
};

Range range_of(const particles::ParticleSet &set, int axis) {
  if (set.has_box) return {set.box_min[axis], set.box_max[axis]};
  Range range;
  for (size_t i = 0; i < set.count(); i++) {
    const double x = set.centers[i * static_cast<size_t>(set.dimension) + static_cast<size_t>(axis)];
    const double low = x - set.radii[i], high = x + set.radii[i];
    range = i == 0 ? Range{low, high} : Range{std::min(range.low, low), std::max(range.high, high)};
  }
  return range;
}

// The level of insertion: the finest that takes the radius.
size_t level_of(const std::vector<Level> &levels, double radius) {
  size_t level = 0;
  while (level + 1 < levels.size() && levels[level].largest_radius < radius) level++;
  return level;
}

// Adds the disk and its periodic images that still show in the box.
void add_images(const particles::ParticleSet &set, const int axes[2], const Range ranges[2], const Disk &disk,
                Slice &slice) {
  int images[2] = {0, 0};
  double length[2];
  for (int k = 0; k < 2; k++) {
    length[k] = ranges[k].high - ranges[k].low;
    images[k] = set.periodic[axes[k]] != 0 ? 1 : 0;
  }
  for (int i = -images[0]; i <= images[0]; i++) {
    for (int j = -images[1]; j <= images[1]; j++) {
      Disk image = disk;
      image.u += i * length[0];
      image.v += j * length[1];
      const bool shows = image.u + image.radius > ranges[0].low && image.u - image.radius < ranges[0].high &&
                         image.v + image.radius > ranges[1].low && image.v - image.radius < ranges[1].high;
      if (shows || (i == 0 && j == 0)) slice.disks.push_back(image);
    }
  }
}

}  // namespace

Slice cut(const particles::ParticleSet &set, const std::vector<Level> &levels, int axis, double at) {
  const int axes[2] = {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
  const size_t d = static_cast<size_t>(set.dimension);
  Slice slice;
  slice.levels = levels;
  slice.axis = axis;
  const Range ranges[2] = {range_of(set, axes[0]), range_of(set, axes[1])};
  slice.box = {ranges[0].low, ranges[1].low, ranges[0].high - ranges[0].low, ranges[1].high - ranges[1].low};
  Range depth;
  if (d == 3) {
    depth = range_of(set, axis);
    slice.position = depth.low + at * (depth.high - depth.low);
  }
  for (size_t i = 0; i < set.count(); i++) {
    const double *x = &set.centers[i * d];
    double offset = d == 3 ? x[axis] - slice.position : 0;
    if (d == 3 && set.periodic[axis] != 0) {
      const double length = depth.high - depth.low;
      offset -= length * std::floor(offset / length + 0.5);
    }
    const double square = set.radii[i] * set.radii[i] - offset * offset;
    if (!(square > 0)) continue;
    const Disk disk{x[axes[0]], x[axes[1]], std::sqrt(square), set.radii[i], level_of(levels, set.radii[i])};
    add_images(set, axes, ranges, disk, slice);
  }
  // Large ones first, so that no small one is hidden.
  std::stable_sort(slice.disks.begin(), slice.disks.end(),
                   [](const Disk &a, const Disk &b) { return a.radius > b.radius; });
  return slice;
}

size_t count_in(const Slice &slice, const Window &window) {
  return static_cast<size_t>(std::count_if(slice.disks.begin(), slice.disks.end(),
                                           [&window](const Disk &disk) { return meets(window, disk); }));
}

}  // namespace draw
