// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Sorts a short row of partners by a bitonic network in vectors of eight (Batcher 1968).
#pragma once

#include <hgrid/types.h>

#include <immintrin.h>

#include <cstddef>
#include <cstdint>

namespace hg {
namespace {

// From the 32nd on, no partner can be larger.
struct BehindRow {
  uint32_t value[64] = {};
  constexpr BehindRow() {
    for (int k = 32; k < 64; k++) value[k] = UINT32_MAX;
  }
};
alignas(64) constexpr BehindRow kBehindRow;

struct Avx2Sorter {
  // Writes the pairs of `a` with its partners, ascending, plus at most 15 behind them. Reads as many.
  static void write(const uint32_t *partners, uint32_t count, int32_t a, uint32_t offset, hg_pair *to) {
    if (__builtin_expect(count <= 8, 1)) {
      write<1>(partners, count, a, offset, to);
    } else if (count <= 16) {
      write<2>(partners, count, a, offset, to);
    } else {
      write<4>(partners, count, a, offset, to);
    }
  }

 private:
  using Int = __m256i;

  // More partners than fit into half of the vectors.
  template <size_t Vectors>
  static void write(const uint32_t *partners, uint32_t count, int32_t a, uint32_t offset, hg_pair *to) {
    Int v[Vectors];
    for (size_t n = 0; n < Vectors; n++) {
      v[n] = load(partners + 8 * n);
      if (n >= Vectors / 2) v[n] = _mm256_or_si256(v[n], load(kBehindRow.value + 32 - count + 8 * n));
    }
    sort<Vectors>(v);
    const Int first = _mm256_set1_epi32(a), shift = _mm256_set1_epi32(static_cast<int32_t>(offset));
    for (size_t n = 0; n < Vectors; n++) {
      const Int second = _mm256_add_epi32(v[n], shift);
      const Int even = _mm256_unpacklo_epi32(first, second), odd = _mm256_unpackhi_epi32(first, second);
      store(to + 8 * n, _mm256_permute2x128_si256(even, odd, 0x20));
      store(to + 8 * n + 4, _mm256_permute2x128_si256(even, odd, 0x31));
    }
  }

  template <size_t Vectors>
  static void sort(Int *v) {
    if constexpr (Vectors == 1) {
      v[0] = exchange<1>(v[0]);
      v[0] = exchange<1>(exchange<3>(v[0]));
      v[0] = exchange<1>(exchange<2>(exchange<7>(v[0])));
    } else {
      constexpr size_t kHalf = Vectors / 2;
      sort<kHalf>(v);
      sort<kHalf>(v + kHalf);
      Int back[kHalf];  // the second half from its end on: with the first half it rises, then falls
      for (size_t n = 0; n < kHalf; n++) back[n] = across<7>(v[Vectors - 1 - n]);
      for (size_t n = 0; n < kHalf; n++) v[kHalf + n] = back[n];
      merge<Vectors>(v);
    }
  }

  // Of what rises and then falls.
  template <size_t Vectors>
  static void merge(Int *v) {
    if constexpr (Vectors == 1) {
      v[0] = exchange<1>(exchange<2>(exchange<4>(v[0])));
    } else {
      constexpr size_t kHalf = Vectors / 2;
      for (size_t n = 0; n < kHalf; n++) {
        const Int low = _mm256_min_epu32(v[n], v[kHalf + n]);
        v[kHalf + n] = _mm256_max_epu32(v[n], v[kHalf + n]);
        v[n] = low;
      }
      merge<kHalf>(v);
      merge<kHalf>(v + kHalf);
    }
  }

  // Of the lanes i and i ^ X the one whose highest bit of X is set takes the larger.
  template <int X>
  static Int exchange(Int a) {
    const Int b = across<X>(a);
    return _mm256_blend_epi32(_mm256_min_epu32(a, b), _mm256_max_epu32(a, b), X == 1 ? 0xaa : (X < 4 ? 0xcc : 0xf0));
  }

  // Lane i gets lane i ^ X.
  template <int X>
  static Int across(Int a) {
    if constexpr (X < 4) {
      return _mm256_shuffle_epi32(a, (0 ^ X) | (1 ^ X) << 2 | (2 ^ X) << 4 | (3 ^ X) << 6);
    } else {
      const Int lane = _mm256_setr_epi32(0 ^ X, 1 ^ X, 2 ^ X, 3 ^ X, 4 ^ X, 5 ^ X, 6 ^ X, 7 ^ X);
      return _mm256_permutevar8x32_epi32(a, lane);
    }
  }

  static Int load(const uint32_t *p) { return _mm256_loadu_si256(reinterpret_cast<const Int *>(p)); }
  static void store(hg_pair *to, Int pairs) { _mm256_storeu_si256(reinterpret_cast<Int *>(to), pairs); }
};

}  // namespace
}  // namespace hg
