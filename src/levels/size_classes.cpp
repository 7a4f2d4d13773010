// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/levels/size_classes.hpp"

#include "src/base/ordered_bits.hpp"
#include "src/base/radix_sort.hpp"

namespace hg {
namespace {

uint64_t ordered_bits(double radius) { return bits_of(radius + 0.0); }  // -0 becomes +0

}  // namespace

void SizeClasses::sort_radii(const double *radii, size_t count, const Interval &extremes) {
  radius_.require(count);
  end_.require(count);
  keys_.require(2 * count);
  count_ = 0;
  if (count == 0) return;
  // Counted from the least, bits that all have in common are 0 and need no digit.
  const uint64_t least = ordered_bits(extremes.least);
  uint64_t *keys = keys_.data();
  for (size_t i = 0; i < count; i++) keys[i] = ordered_bits(radii[i]) - least;
  const int bits = bit_width(ordered_bits(extremes.greatest) - least);
  const uint64_t *sorted = radix_sort_from_top(keys, keys + count, count, bits);
  for (size_t i = 0; i < count; i++) {
    if (i + 1 < count && sorted[i + 1] == sorted[i]) continue;
    radius_[count_] = from_bits(least + sorted[i]);
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
