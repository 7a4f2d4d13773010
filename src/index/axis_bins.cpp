// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/index/axis_bins.hpp"

#include "src/base/ordered_bits.hpp"
#include "src/base/radix_sort.hpp"

#include <algorithm>
#include <cmath>

namespace hg {
namespace {

constexpr size_t kFewPlaces = 1024;
constexpr int kLeastExponent = -1000;  // of a width, for its inverse to be finite
constexpr double kMostBins = 0x1p52;   // from 0 on; beyond, neighbouring doubles are a width apart
constexpr size_t kMostSteps = 256;     // to a place; far more than chance makes
constexpr int kMostSpreads = 8;
constexpr uint64_t kSpread = 0x9e3779b97f4a7c15u;

// Unsigned numbers in the order of the doubles; -0.0 comes before 0.0.
uint64_t ascending_bits(double x) {
  const uint64_t bits = bits_of(x);
  return bits ^ (bits >> 63 != 0 ? ~uint64_t{0} : uint64_t{1} << 63);
}

}  // namespace

void AxisBins::begin(double width, size_t positions) {
  int exponent = 0;
  std::frexp(width, &exponent);
  exponent--;
  // Powers of two, so that nothing is rounded; without one, each position has a bin of its own.
  width_ = std::ldexp(1.0, std::max(exponent, kLeastExponent));
  inverse_ = exponent < kLeastExponent ? HUGE_VAL : 1 / width_;
  size_t places = kFewPlaces;
  while (places < 2 * count_) places *= 2;  // as many bins as the last time
  count_ = 0;
  spread_ = kSpread;
  spreads_ = 1;
  of_.require_room(positions);
  place_bits_ = 0;
  make_places(places);
}

// The lower edge of the bin.
double AxisBins::low_of(double x) const {
  const double bins = x * inverse_;
  if (!(bins > -kMostBins && bins < kMostBins)) return x;
  const auto cut = static_cast<int64_t>(bins);
  const int64_t above = static_cast<double>(cut) > bins ? 1 : 0;  // added, as a branch would be taken at random
  return static_cast<double>(cut - above) * width_;
}

size_t AxisBins::hash(double low) const {
  const uint64_t bits = bits_of(low);
  return static_cast<size_t>((bits ^ bits >> 32) * spread_ >> (64 - place_bits_));
}

// Bins that are there find other places.
void AxisBins::make_places(size_t places) {
  const size_t before = place_bits_ == 0 ? 0 : size_t{1} << place_bits_;
  const Place *old_place = place_;
  Buffer<Place> &table = table_[place_ == table_[0].data() ? 1 : 0];
  table.require(places);
  place_ = table.data();
  place_bits_ = bit_width(places) - 1;
  for (size_t at = 0; at < places; at++) place_[at].bin = kNone;
  for (size_t n = 0; n < before; n++) {
    const Place &old = old_place[n];
    if (old.bin == kNone) continue;
    size_t at = hash(old.low);
    while (place_[at].bin != kNone) at = (at + 1) & (places - 1);
    place_[at] = old;
  }
}

// In steps, each of which asks for what the next one needs.
void AxisBins::add(size_t number, const double *x, size_t positions) {
  double low[kTogether];
  uint32_t bin[kTogether];
  for (size_t i = 0; i < positions; i++) {
    low[i] = low_of(x[i]);
    __builtin_prefetch(place_ + hash(low[i]));
  }
  for (size_t i = 0; i < positions; i++) {
    bin[i] = find_or_add(low[i], x[i]);
    __builtin_prefetch(bins_.data() + bin[i], 1);
  }
  for (size_t i = 0; i < positions; i++) {
    Bin &here = bins_[bin[i]];
    here.least = std::min(here.least, x[i]);
    here.greatest = std::max(here.greatest, x[i]);
    of_[number + i] = bin[i];
  }
}

uint32_t AxisBins::find_or_add(double low, double x) {
  const uint64_t bits = bits_of(low);
  size_t last = 0, at = 0;
  for (;;) {
    size_t steps = 0;
    last = (size_t{1} << place_bits_) - 1;
    for (at = hash(low); place_[at].bin != kNone; at = (at + 1) & last, steps++) {
      if (bits_of(place_[at].low) == bits) return place_[at].bin;
    }
    if (__builtin_expect(steps < kMostSteps || spreads_ == kMostSpreads, 1)) break;
    spread_ *= kSpread;  // positions made so that they meet: not with another hash
    spreads_++;
    make_places(last + 1);
  }
  const auto bin = static_cast<uint32_t>(count_);
  bins_.grow(count_ + 1);
  bins_[count_++] = {x, x};
  place_[at] = {low, bin};
  if (2 * count_ > last) make_places(2 * (last + 1));
  return bin;
}

void AxisBins::sort() {
  sorted_.require_room(count_);
  other_.require_room(count_);
  size_t found = 0;
  for (size_t at = 0; at < size_t{1} << place_bits_; at++) {
    if (place_[at].bin != kNone) sorted_[found++] = {ascending_bits(place_[at].low), place_[at].bin};
  }
  order_ = radix_sort(sorted_.data(), other_.data(), count_, 64, [](const Key &key) { return key.bits; });
}

}  // namespace hg
