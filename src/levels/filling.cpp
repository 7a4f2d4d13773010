// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/levels/filling.hpp"

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
    for (int k = 0; k < dimension; k++) key = key << 1 | (static_cast<uint32_t>(x[k]) >> bit & 1u);
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

Filling Filling::sample(const ParticleStore &store, const Domain &domain, const Frame &frame) {
  const size_t count = store.slots(), taken = std::min(count, kSample);
  uint64_t keys[kSample];
  for (size_t i = 0; i < taken; i++) {
    const double *center = store.center(i * count / taken);
    int32_t x[3] = {0, 0, 0};
    for (int k = 0; k < domain.dimension; k++) x[k] = frame.coordinate(k, domain.position(k, center[k]));
    keys[i] = interleaved(x, domain.dimension);
  }
  std::sort(keys, keys + taken);

  Filling filling;
  const double all_pairs = 0.5 * static_cast<double>(taken) * (static_cast<double>(taken) - 1);
  for (int octave = kOctaves - 1; octave >= 0; octave--) {
    double &density = filling.density_[octave];
    const int shift = domain.dimension * (octave - (30 - kKeyOctaves));
    const int64_t pairs = shift < 0 ? 0 : pairs_in_one_cell(keys, taken, shift);
    if (octave < kOctaves - 1 && pairs < kFewPairs) {
      // Evenly from here down.
      std::fill(filling.density_, &density + 1, filling.density_[octave + 1]);
      break;
    }
    const double edge = std::ldexp(1.0, octave), volume = domain.dimension == 3 ? edge * edge * edge : edge * edge;
    density = (all_pairs > 0 ? static_cast<double>(pairs) / all_pairs : 1) / volume;
  }
  return filling;
}

Filling Filling::even(const double *extent, int dimension) {
  Filling filling;
  for (int octave = 0; octave < kOctaves; octave++) {
    double volume = 1;
    for (int k = 0; k < dimension; k++) volume *= std::max(extent[k], std::ldexp(1.0, octave));
    filling.density_[octave] = 1 / volume;
  }
  return filling;
}

double Filling::density(double length) const {
  int exponent = 0;
  const double mantissa = std::frexp(std::clamp(length, 1.0, kFrameQuanta), &exponent);  // in [1/2, 1)
  const double finer = density_[exponent - 1];
  if (exponent >= kOctaves) return finer;
  return finer + (density_[exponent] - finer) * (2 * mantissa - 1);
}

}  // namespace hg
