// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/levels/density.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hg {
namespace {

constexpr size_t kSample = 1024;
// Pairs of the sample that must share cells for their number to be trusted: then it is off by a tenth or so.
constexpr int64_t kFewPairs = 100;
constexpr int kKeyOctaves = 20;  // octaves below the whole that a key of 64 bits can hold for each of three axes

// Bits of the coordinates in turns, coarsest first: cells of any edge 2^j are runs of sorted keys.
uint64_t interleaved(const int32_t *x, int dimension) {
  uint64_t key = 0;
  for (int bit = 29; bit >= 30 - kKeyOctaves; bit--) {
    for (int axis = 0; axis < dimension; axis++) key = key << 1 | (static_cast<uint32_t>(x[axis]) >> bit & 1u);
  }
  return key;
}

int64_t pairs_in_one_cell(const uint64_t *keys, size_t count, int shift) {
  int64_t pairs = 0;
  int64_t before = 0;  // in the cell of the key at hand
  for (size_t i = 1; i < count; i++) {
    before = keys[i] >> shift == keys[i - 1] >> shift ? before + 1 : 0;
    pairs += before;
  }
  return pairs;
}

}  // namespace

Density Density::sample(const Participants &particles, const FixedPoint &map, int dimension) {
  const size_t count = particles.count(), taken = std::min(count, kSample);
  uint64_t keys[kSample];
  for (size_t i = 0; i < taken; i++) {
    int32_t x[3] = {0, 0, 0};
    map.find_coordinates(particles.center(i * count / taken), dimension, x);
    keys[i] = interleaved(x, dimension);
  }
  std::sort(keys, keys + taken);

  Density found;
  const double all_pairs = 0.5 * static_cast<double>(taken) * (static_cast<double>(taken) - 1);
  for (int octave = kOctaves - 1; octave >= 0; octave--) {
    double &density = found.per_octave_[octave];
    const int shift = dimension * (octave - (30 - kKeyOctaves));
    const int64_t pairs = shift < 0 ? 0 : pairs_in_one_cell(keys, taken, shift);
    if (octave < kOctaves - 1 && pairs < kFewPairs) {
      // Evenly from here down.
      std::fill(found.per_octave_, &density + 1, found.per_octave_[octave + 1]);
      break;
    }
    const double edge = std::ldexp(1.0, octave), volume = dimension == 3 ? edge * edge * edge : edge * edge;
    density = (all_pairs > 0 ? static_cast<double>(pairs) / all_pairs : 1) / volume;
  }
  return found;
}

Density Density::even(const double *extent, int dimension) {
  Density found;
  for (int octave = 0; octave < kOctaves; octave++) {
    double volume = 1;
    for (int axis = 0; axis < dimension; axis++) volume *= std::max(extent[axis], std::ldexp(1.0, octave));
    found.per_octave_[octave] = 1 / volume;
  }
  return found;
}

double Density::at(double length) const {
  int exponent = 0;
  const double mantissa = std::frexp(std::clamp(length, 1.0, kFixedPointQuanta), &exponent);  // in [1/2, 1)
  const double finer = per_octave_[exponent - 1];
  if (exponent >= kOctaves) return finer;
  return finer + (per_octave_[exponent] - finer) * (2 * mantissa - 1);
}

}  // namespace hg
