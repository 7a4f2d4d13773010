// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Four doubles side by side: AVX2 (x86-64-v3).
#pragma once

#include "src/kernels/lanes_avx2.hpp"

#include <cstddef>

namespace hg {
namespace {

// A particle, or what leads from one to another: x, y, z (0 in 2D), radius or base of the reach.
struct RowOfFour {
  using Float = __m256d;
  static Float add(Float a, Float b) { return _mm256_add_pd(a, b); }
  static Float max(Float a, Float b) { return _mm256_max_pd(b, a); }  // of equals a, as std::max

  template <class Rule>
  static Float apart(Float a, Float b) {
    return _mm256_blend_pd(_mm256_sub_pd(b, a), Rule::template base<RowOfFour>(a, b), 0x8);
  }
};

struct Avx2Doubles {
  static constexpr uint32_t kLanes = 4;
  using Double = __m256d;
  using Pairs = __m256i;

  // What leads from a to b, and the base of the reach.
  struct Apart {
    Double x, y, z, base;
  };

  static Double set(double a) { return _mm256_set1_pd(a); }
  static Double add(Double a, Double b) { return _mm256_add_pd(a, b); }
  static Double mul(Double a, Double b) { return _mm256_mul_pd(a, b); }
  static Double max(Double a, Double b) { return _mm256_max_pd(a, b); }
  static uint32_t less(Double a, Double b) {
    return static_cast<uint32_t>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LT_OQ)));
  }

  static Pairs load_pairs(const hg_pair *pairs) { return _mm256_loadu_si256(reinterpret_cast<const __m256i *>(pairs)); }

  // A row for each pair, then turned into columns.
  template <int D, class Rule>
  static Apart apart(const double *centers, const double *radii, const hg_pair *pairs) {
    __m256d row[4];
    for (size_t k = 0; k < 4; k++) {
      row[k] = RowOfFour::apart<Rule>(particle<D>(centers, radii, pairs[k].a), particle<D>(centers, radii, pairs[k].b));
    }
    const __m256d xz01 = _mm256_unpacklo_pd(row[0], row[1]), yr01 = _mm256_unpackhi_pd(row[0], row[1]);
    const __m256d xz23 = _mm256_unpacklo_pd(row[2], row[3]), yr23 = _mm256_unpackhi_pd(row[2], row[3]);
    return {_mm256_permute2f128_pd(xz01, xz23, 0x20), _mm256_permute2f128_pd(yr01, yr23, 0x20),
            _mm256_permute2f128_pd(xz01, xz23, 0x31), _mm256_permute2f128_pd(yr01, yr23, 0x31)};
  }

  // Those of the lanes that are found, in order; anything behind.
  static void compress(double *to, Double a, uint32_t found) {
    _mm256_storeu_pd(to, _mm256_castsi256_pd(compressed(_mm256_castpd_si256(a), found)));
  }
  static void compress_pairs(hg_pair *to, Pairs pairs, uint32_t found, int32_t offset) {
    _mm256_storeu_si256(reinterpret_cast<__m256i *>(to), compressed(ids(pairs, offset), found));
  }
  static void compress_slots(int32_t *a, int32_t *b, Pairs pairs, uint32_t found, int32_t offset) {
    const __m256i apart =
        _mm256_permutevar8x32_epi32(compressed(ids(pairs, offset), found), _mm256_setr_epi32(0, 2, 4, 6, 1, 3, 5, 7));
    _mm_storeu_si128(reinterpret_cast<__m128i *>(a), _mm256_castsi256_si128(apart));
    _mm_storeu_si128(reinterpret_cast<__m128i *>(b), _mm256_extracti128_si256(apart, 1));
  }

 private:
  static __m256i ids(Pairs pairs, int32_t offset) { return _mm256_add_epi32(pairs, _mm256_set1_epi32(offset)); }
  // Each lane is two of those of Avx2Lanes.
  static __m256i compressed(__m256i a, uint32_t found) {
    const uint32_t spread = (found & 1u) | (found & 2u) << 1 | (found & 4u) << 2 | (found & 8u) << 3;
    return Avx2Lanes::compressed(a, 3 * spread);
  }
  template <int D>
  static __m256d particle(const double *centers, const double *radii, int32_t slot) {
    const auto at = static_cast<size_t>(static_cast<uint32_t>(slot));
    const double *center = centers + at * D;
    const __m128d last = _mm_load_sd(D == 3 ? center + 2 : radii + at);
    const __m128d high = D == 3 ? _mm_loadh_pd(last, radii + at) : _mm_unpacklo_pd(_mm_setzero_pd(), last);
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(center)), high, 1);
  }
};

}  // namespace
}  // namespace hg
