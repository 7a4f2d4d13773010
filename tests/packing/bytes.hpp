// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether packings are the same to the last bit.
#pragma once

#include "particles/particle_set.hpp"

#include <cstdint>
#include <cstring>
#include <vector>

namespace test {

inline bool same_bytes(const std::vector<double> &a, const std::vector<double> &b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

// FNV-1a over the bit patterns, coordinates first.
inline uint64_t hash_of(const particles::ParticleSet &set) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (const std::vector<double> *values : {&set.centers, &set.radii}) {
    for (const double value : *values) {
      uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      for (int k = 0; k < 8; k++) hash = (hash ^ ((bits >> (8 * k)) & 255u)) * 0x100000001b3u;
    }
  }
  return hash;
}

}  // namespace test
