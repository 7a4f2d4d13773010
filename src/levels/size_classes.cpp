// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/levels/size_classes.hpp"

#include "src/base/ordered_bits.hpp"

#include <algorithm>

namespace hg {
namespace {

uint64_t ordered_bits(double radius) { return bits_of(radius + 0.0); }  // -0 becomes +0

}  // namespace

void SizeClasses::sort_radii(const double *radii, size_t count) {
  radius_.require(count);
  end_.require(count);
  std::copy(radii, radii + count, radius_.data());
  std::sort(radius_.data(), radius_.data() + count);
  count_ = 0;
  for (size_t i = 0; i < count; i++) {
    if (i + 1 < count && radius_[i + 1] == radius_[i]) continue;
    radius_[count_] = radius_[i];
    end_[count_++] = static_cast<int64_t>(i + 1);
  }
}

void SizeClasses::bin_radii(const double *radii, size_t count, const Interval &extremes) {
  radius_.require(kBins);
  end_.require(kBins);
  count_ = 0;
  if (count == 0) return;
  const uint64_t last = ordered_bits(extremes.greatest);
  int shift = 0;
  while ((last >> shift) - (ordered_bits(extremes.least) >> shift) >= kBins) shift++;
  const uint64_t first = ordered_bits(extremes.least) >> shift;

  // Neighbours in memory often share a bin; two tables keep their increments apart.
  uint32_t even[kBins] = {}, odd[kBins] = {};
  size_t i = 0;
  for (; i + 1 < count; i += 2) {
    even[(ordered_bits(radii[i]) >> shift) - first]++;
    odd[(ordered_bits(radii[i + 1]) >> shift) - first]++;
  }
  if (i < count) even[(ordered_bits(radii[i]) >> shift) - first]++;

  int64_t so_far = 0;
  for (uint64_t bin = 0; bin < kBins; bin++) {
    const int64_t here = static_cast<int64_t>(even[bin]) + odd[bin];
    if (here == 0) continue;
    so_far += here;
    const uint64_t greatest_in_bin = ((first + bin + 1) << shift) - 1;
    radius_[count_] = from_bits(greatest_in_bin < last ? greatest_in_bin : last);
    end_[count_++] = so_far;
  }
}

}  // namespace hg
