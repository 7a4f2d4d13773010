// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The random numbers of packings and simulations: xoshiro256++ and mappings of our own, so that a seed means the same
// bytes everywhere (the distributions of the standard library differ between implementations).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace packing {

// xoshiro256++ 1.0 of Blackman and Vigna, its state filled from one seed by splitmix64 as they advise.
class Random {
 public:
  using State = std::array<uint64_t, 4>;

  explicit Random(uint64_t seed) {
    for (uint64_t &word : state_) word = split_mix(seed);
  }
  explicit Random(const State &state) : state_(state) {}

  uint64_t next() {
    const uint64_t result = rotate(state_[0] + state_[3], 23) + state_[0];
    const uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = rotate(state_[3], 45);
    return result;
  }

  // Uniform in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  // Mean 0 and variance 1, nearly Gaussian: the sum of twelve uniform numbers less 6. No logarithm or cosine, whose
  // last bits differ between C libraries.
  double normal() {
    double sum = -6;
    for (int k = 0; k < 12; k++) sum += uniform();
    return sum;
  }

  // Uniform in 0 .. bound - 1, bound > 0. Numbers below 2^64 mod bound are drawn again, which leaves no bias.
  uint64_t below(uint64_t bound) {
    const uint64_t first_fair = (0 - bound) % bound;
    for (;;) {
      const uint64_t number = next();
      if (number >= first_fair) return number % bound;
    }
  }

 private:
  static uint64_t rotate(uint64_t word, int bits) { return (word << bits) | (word >> (64 - bits)); }

  static uint64_t split_mix(uint64_t &seed) {
    seed += 0x9e3779b97f4a7c15u;
    uint64_t z = seed;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  State state_{};
};

// Fisher and Yates: every order equally likely.
template <class T>
void shuffle(std::vector<T> &items, Random &random) {
  for (size_t left = items.size(); left > 1; left--) {
    std::swap(items[left - 1], items[random.below(left)]);
  }
}

}  // namespace packing
