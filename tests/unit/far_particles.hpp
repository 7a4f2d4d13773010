// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles in a space that is mostly empty, sorted into chunks of rows. Lengths are quanta: a place is a center.
#pragma once

#include "src/index/chunk_rows.hpp"
#include "tests/support/rng.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hgtest {

// Widths of levels, from dust to giants, and of the space.
struct FarShape {
  int dimension = 3;
  double extent[3] = {0, 0, 0};
  std::vector<double> diameter;  // of each level, at most
};

inline FarShape any_far_shape(Rng &rng, int most_levels) {
  FarShape shape;
  shape.dimension = rng.integer(2, 3);
  const double bits = rng.uniform(20, 48);
  for (int axis = 0; axis < shape.dimension; axis++) {
    shape.extent[axis] = std::floor(std::pow(2, rng.chance(0.3) ? rng.uniform(0, bits) : bits));
  }
  const double growth = rng.chance(0.3) ? 0.5 : 6;
  double diameter = std::pow(2, rng.uniform(0, 14));
  for (int h = rng.integer(1, most_levels); h > 0; h--) {
    shape.diameter.push_back(diameter);
    diameter *= std::pow(2, rng.uniform(0.01, growth));
    if (diameter > 0x1p40) break;
  }
  return shape;
}

class FarParticles {
 public:
  explicit FarParticles(const FarShape &shape) : dimension(shape.dimension), diameter(shape.diameter) {
    std::copy_n(shape.extent, 3, map.extent);  // scale 1, origin 0
    levels.resize(diameter.size());
  }

  // A particle of the level, as wide as its diameter or less, at the whole place nearest to `at` in space.
  void add(Rng &rng, size_t level, const double *at) {
    const double least = level == 0 ? 0 : share * diameter[level - 1];
    double r = share * diameter[level];
    if (rng.chance(0.7)) r -= rng.uniform() * (r - least);
    for (int axis = 0; axis < dimension; axis++) {
      centers.push_back(std::clamp(std::rint(at[axis]), 0.0, map.extent[axis]));
    }
    radii.push_back(r);
    levels[level]++;
  }

  // Groups, as dense as their particles are wide, anywhere; chains with steps of a few cells; some at one place.
  void add_groups(Rng &rng, size_t count) {
    while (radii.size() < count) {
      const size_t level = rng.below(diameter.size());
      const double width = diameter[level] + 512;
      double at[3], step[3];
      const bool chain = rng.chance(0.3);
      for (int axis = 0; axis < 3; axis++) {
        at[axis] = rng.chance(0.2) ? map.extent[axis] * rng.integer(0, 1) : map.extent[axis] * rng.uniform();
        if (rng.chance(0.3)) at[axis] = std::rint(at[axis] / 0x1p32) * 0x1p32;  // where coordinates wrap
        step[axis] = rng.chance(axis == 0 ? 0.1 : 0.6) ? 0 : width * rng.integer(-9, 9) * 0.5;
      }
      const double spread = width * std::pow(2, rng.uniform(-3, 4));
      for (int n = rng.integer(1, 150); n > 0 && radii.size() < count; n--) {
        double place[3];
        for (int axis = 0; axis < 3; axis++) {
          place[axis] = chain ? at[axis] : at[axis] + spread * rng.uniform(-1, 1);
          at[axis] += chain ? step[axis] : 0;
        }
        add(rng, rng.chance(0.8) ? level : rng.below(diameter.size()), place);
      }
    }
  }

  size_t count() const { return radii.size(); }
  // By slot.
  double center(size_t n, int axis) const {
    return centers[n * static_cast<size_t>(dimension) + static_cast<size_t>(axis)];
  }
  // Place in sorted order, 0 along an axis that is not there.
  double place(size_t i, int axis) const { return axis < dimension ? center(slot[i], axis) : 0; }
  hg::ChunkInput input() const {
    return {{centers.data(), radii.data(), nullptr, map, 0}, 0, nullptr, 0};
  }  // open axes
  hg::PointArrays points() const {
    return {x[0].data(), x[1].data(), x[2].data(), radius.data(), slot.data(), nullptr};
  }

  void sort_into(hg::ChunkRows &chunks, hg::ChunkScratch &scratch) {
    hg::ChunkRows::Sizes sizes;
    std::vector<double> present = diameter;
    sizes.insertion_levels = static_cast<int>(diameter.size());
    for (size_t h = 0; h < diameter.size(); h++) {
      if (levels[h] == 0) present[h] = diameter.back();
      sizes.radius_limit[h] = share * diameter[h];
    }
    sizes.diameter = present.data();
    sizes.classes.begin[1] = count();
    slot.assign(count() + hg::kPadding, 0);
    chunks.build(input(), sizes, dimension, slot.data(), scratch, 1);
    for (auto &column : x) column.assign(count() + hg::kPadding, 0);
    radius.assign(count() + hg::kPadding, 0);
    for (size_t i = 0; i < count(); i++) {
      for (int axis = 0; axis < dimension; axis++) x[axis][i] = hg::low_word(place(i, axis));
      radius[i] = static_cast<float>(radii[slot[i]]);
    }
    giants_begin = static_cast<uint32_t>(count());
    for (size_t h = diameter.size(); h-- > 0 && chunks.level(static_cast<int>(h)).giants;) {
      giants_begin -= static_cast<uint32_t>(levels[h]);
    }
    chunks.place_giants(input(), slot.data(), giants_begin, count(), dimension);
  }

  int dimension;
  std::vector<double> diameter;
  double share = 0.5;  // the radius of a particle that is as wide as its level's diameter, over that
  hg::FixedPoint map;
  std::vector<double> centers, radii;  // by slot
  std::vector<size_t> levels;          // particles on each
  std::vector<uint32_t> slot;          // in sorted order, as all that follows
  std::vector<int32_t> x[3];
  std::vector<float> radius;
  uint32_t giants_begin = 0;
};

}  // namespace hgtest
