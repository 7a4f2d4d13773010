// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Random numbers that are the same with every compiler and library: xoshiro256** seeded by splitmix64.
#pragma once

#include <cstdint>

namespace hgtest {

class Rng {
 public:
  explicit Rng(uint64_t seed) {
    for (uint64_t &word : state_) {
      seed += 0x9e3779b97f4a7c15U;
      uint64_t z = seed;
      z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
      z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
      word = z ^ (z >> 31);
    }
  }

  uint64_t next() {
    const uint64_t result = rotate(state_[1] * 5, 7) * 9;
    const uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = rotate(state_[3], 45);
    return result;
  }

  // In [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  // In 0 .. bound - 1; the bias of the remainder is below bound / 2^64 and of no matter here.
  uint64_t below(uint64_t bound) { return next() % bound; }
  // In low .. high, both included.
  int integer(int low, int high) {
    return static_cast<int>(low + static_cast<int64_t>(below(static_cast<uint64_t>(int64_t{high} - low + 1))));
  }
  bool chance(double probability) { return uniform() < probability; }

 private:
  static uint64_t rotate(uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

  uint64_t state_[4];
};

}  // namespace hgtest
