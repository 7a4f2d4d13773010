// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Eight doubles side by side: AVX-512 F, BW, DQ, VL.
#pragma once

#include "src/kernels/doubles_avx2.hpp"

namespace hg {
namespace {

// As Avx2Doubles.
struct Avx512Doubles {
  static constexpr uint32_t kLanes = 8;
  using Double = __m512d;
  using Pairs = __m512i;

  struct Apart {
    Double x, y, z, base;
  };

  static Double set(double a) { return _mm512_set1_pd(a); }
  static Double add(Double a, Double b) { return _mm512_add_pd(a, b); }
  static Double mul(Double a, Double b) { return _mm512_mul_pd(a, b); }
  static Double max(Double a, Double b) { return _mm512_max_pd(a, b); }
  static uint32_t less(Double a, Double b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }

  static Pairs load_pairs(const hg_pair *pairs) { return _mm512_loadu_si512(pairs); }

  template <int D, class Rule>
  static Apart apart(const double *centers, const double *radii, const hg_pair *pairs) {
    const auto row_of = [=](const hg_pair &pair) {
      return RowOfFour::apart<Rule>(particle<D>(centers, radii, pair.a), particle<D>(centers, radii, pair.b));
    };
    __m512d row[4];
    for (size_t k = 0; k < 4; k++) {
      row[k] = _mm512_insertf64x4(_mm512_castpd256_pd512(row_of(pairs[k])), row_of(pairs[k + 4]), 1);
    }
    const __m512d xz01 = _mm512_unpacklo_pd(row[0], row[1]), yr01 = _mm512_unpackhi_pd(row[0], row[1]);
    const __m512d xz23 = _mm512_unpacklo_pd(row[2], row[3]), yr23 = _mm512_unpackhi_pd(row[2], row[3]);
    const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
    const __m512i high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
    return {_mm512_permutex2var_pd(xz01, low, xz23), _mm512_permutex2var_pd(yr01, low, yr23),
            _mm512_permutex2var_pd(xz01, high, xz23), _mm512_permutex2var_pd(yr01, high, yr23)};
  }

  static void compress(double *to, Double a, uint32_t found) {
    _mm512_storeu_pd(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(found), a));
  }
  static void compress_pairs(hg_pair *to, Pairs pairs, uint32_t found, int32_t offset) {
    _mm512_storeu_si512(to, compressed(pairs, found, offset));
  }
  static void compress_slots(int32_t *a, int32_t *b, Pairs pairs, uint32_t found, int32_t offset) {
    const Pairs kept = compressed(pairs, found, offset);
    _mm256_storeu_si256(reinterpret_cast<__m256i *>(a), _mm512_cvtepi64_epi32(kept));
    _mm256_storeu_si256(reinterpret_cast<__m256i *>(b), _mm512_cvtepi64_epi32(_mm512_srli_epi64(kept, 32)));
  }

 private:
  static Pairs compressed(Pairs pairs, uint32_t found, int32_t offset) {
    return _mm512_maskz_compress_epi64(static_cast<__mmask8>(found),
                                       _mm512_add_epi32(pairs, _mm512_set1_epi32(offset)));
  }
  template <int D>
  static __m256d particle(const double *centers, const double *radii, int32_t slot) {
    const auto at = static_cast<size_t>(static_cast<uint32_t>(slot));
    const __m256d center = _mm256_maskz_loadu_pd(D == 3 ? 0x7 : 0x3, centers + at * D);
    return _mm256_mask_broadcastsd_pd(center, 0x8, _mm_load_sd(radii + at));
  }
};

}  // namespace
}  // namespace hg
