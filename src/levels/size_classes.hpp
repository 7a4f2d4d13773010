// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The size distribution of the particles as the level rules see it: classes of radii in ascending order.
#pragma once

#include "src/base/interval.hpp"
#include "src/base/memory.hpp"

#include <cstddef>
#include <cstdint>

namespace hg {

class SizeClasses {
 public:
  explicit SizeClasses(Memory &memory) : radius_(memory), end_(memory), keys_(memory) {}

  // `extremes`: of the radii. One class for each distinct radius. O(N).
  void sort_radii(const double *radii, size_t count, const Interval &extremes);
  // At most kBins classes of nearly equal radii, equal radii always together. O(N).
  void bin_radii(const double *radii, size_t count, const Interval &extremes);

  size_t count() const { return count_; }
  // No radius of the class is above this, none of the next class is at or below it.
  double largest_radius(size_t c) const { return radius_[c]; }
  // Particles in the classes [first, c].
  int64_t particles(size_t first, size_t c) const { return end_[c] - (first == 0 ? 0 : end_[first - 1]); }

  static constexpr size_t kBins = 1024;

 private:
  Buffer<double> radius_;  // upper end of the class
  Buffer<int64_t> end_;    // particles in this class and all smaller ones
  Buffer<uint64_t> keys_;  // to sort radii by
  size_t count_ = 0;
};

}  // namespace hg
