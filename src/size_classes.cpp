// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "size_classes.hpp"

#include <algorithm>
#include <cstring>

namespace hg {
namespace {

// Doubles >= 0 order as their bits do.
uint64_t ordered_bits(double value) {
  value += 0.0;  // -0 becomes +0
  uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

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

void SizeClasses::bin_radii(const double *radii, size_t count) {
  radius_.require(kBins);
  end_.require(kBins);
  count_ = 0;
  if (count == 0) return;
  double least = radii[0], greatest = radii[0];
  for (size_t i = 0; i < count; i++) {
    least = radii[i] < least ? radii[i] : least;
    greatest = radii[i] > greatest ? radii[i] : greatest;
  }
  int shift = 0;
  while ((ordered_bits(greatest) >> shift) - (ordered_bits(least) >> shift) >= kBins) shift++;
  const uint64_t first = ordered_bits(least) >> shift;

  std::fill(radius_.data(), radius_.data() + kBins, -1.0);
  std::fill(end_.data(), end_.data() + kBins, 0);
  for (size_t i = 0; i < count; i++) {
    const size_t bin = static_cast<size_t>((ordered_bits(radii[i]) >> shift) - first);
    end_[bin]++;
    radius_[bin] = radii[i] > radius_[bin] ? radii[i] : radius_[bin];
  }
  int64_t so_far = 0;
  for (size_t bin = 0; bin < kBins; bin++) {
    if (end_[bin] == 0) continue;
    so_far += end_[bin];
    radius_[count_] = radius_[bin];
    end_[count_++] = so_far;
  }
}

}  // namespace hg
