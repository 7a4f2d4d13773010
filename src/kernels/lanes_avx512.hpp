// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Sixteen lanes: AVX-512 F, BW, DQ, VL.
#pragma once

#include "src/kernels/points.hpp"

#include <hgrid/types.h>

#include <immintrin.h>

namespace hg {
namespace {

struct Avx512Lanes {
  static constexpr uint32_t kLanes = 16;
  using Float = __m512;
  using Int = __m512i;
  using Mask = __mmask16;

  static Float load(const float *p) { return _mm512_loadu_ps(p); }
  static Int load(const int32_t *p) { return _mm512_loadu_si512(p); }
  static Float set(float a) { return _mm512_set1_ps(a); }
  static Int set(int32_t a) { return _mm512_set1_epi32(a); }
  static Int iota() { return _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15); }

  // As in lanes_sse2.hpp.
  static Int load_points(const Point *points, const int32_t *index) {
    const auto point = [=](size_t pair) {
      return _mm_loadu_si128(reinterpret_cast<const __m128i *>(points + index[2 * pair]));
    };
    const Int two = _mm512_inserti32x4(_mm512_castsi128_si512(point(0)), point(4), 1);
    return _mm512_inserti32x4(_mm512_inserti32x4(two, point(8), 2), point(12), 3);
  }
  static Int low_words(Int a, Int b) { return _mm512_unpacklo_epi32(a, b); }
  static Int high_words(Int a, Int b) { return _mm512_unpackhi_epi32(a, b); }
  static Int low_doubles(Int a, Int b) { return _mm512_unpacklo_epi64(a, b); }
  static Int high_doubles(Int a, Int b) { return _mm512_unpackhi_epi64(a, b); }
  static Float as_float(Int a) { return _mm512_castsi512_ps(a); }

  static Float add(Float a, Float b) { return _mm512_add_ps(a, b); }
  static Float sub(Float a, Float b) { return _mm512_sub_ps(a, b); }
  static Float mul(Float a, Float b) { return _mm512_mul_ps(a, b); }
  static Float min(Float a, Float b) { return _mm512_min_ps(a, b); }
  static Float max(Float a, Float b) { return _mm512_max_ps(a, b); }
  static Float sqrt(Float a) { return _mm512_sqrt_ps(a); }
  static Float to_float(Int a) { return _mm512_cvtepi32_ps(a); }
  static Int truncate(Float a) { return _mm512_cvttps_epi32(a); }

  static Int add(Int a, Int b) { return _mm512_add_epi32(a, b); }
  static Int sub(Int a, Int b) { return _mm512_sub_epi32(a, b); }
  static Int mul(Int a, Int b) { return _mm512_mullo_epi32(a, b); }
  static Int bit_and(Int a, Int b) { return _mm512_and_si512(a, b); }
  static Int halve(Int a) { return _mm512_srai_epi32(a, 1); }

  static Mask less(Float a, Float b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
  static Mask greater(Int a, Int b) { return _mm512_cmpgt_epi32_mask(a, b); }
  static Mask equal(Int a, Int b) { return _mm512_cmpeq_epi32_mask(a, b); }
  static Mask both(Mask a, Mask b) { return static_cast<Mask>(a & b); }
  static Mask either(Mask a, Mask b) { return static_cast<Mask>(a | b); }
  static Mask without(Mask a, Mask b) { return static_cast<Mask>(a & ~b); }
  static uint32_t bits(Mask a) { return a; }
  static uint32_t count(Mask a) { return static_cast<uint32_t>(__builtin_popcount(a)); }

  static int32_t first(Int a) { return _mm_cvtsi128_si32(_mm512_castsi512_si128(a)); }
  static int32_t greatest(Int a, Mask m) { return _mm512_reduce_max_epi32(_mm512_maskz_mov_epi32(m, a)); }
  static Int gather(const uint32_t *p, Int i, Mask m) {
    return _mm512_mask_i32gather_epi32(_mm512_setzero_si512(), m, i, p, 4);
  }
  // As in lanes_avx2.hpp.
  static Int gather_near(const uint32_t *p, Int i, Mask m) {
    const int32_t base = first(_mm512_maskz_compress_epi32(m, i)) - 8;
    const Int from = _mm512_sub_epi32(i, _mm512_set1_epi32(base));
    const Mask far = _mm512_mask_cmpgt_epu32_mask(m, from, _mm512_set1_epi32(31));
    if (__builtin_expect(far != 0 || base < 0, 0)) return gather(p, i, m);
    return _mm512_maskz_permutex2var_epi32(m, _mm512_loadu_si512(p + base), from, _mm512_loadu_si512(p + base + 16));
  }
  static void compress(uint32_t *to, Int a, Mask m) { _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(m, a)); }

  static hg_pair *emit(hg_pair *next, uint32_t slot, const uint32_t *others, uint32_t found, int32_t offset) {
    const Int other = _mm512_maskz_compress_epi32(static_cast<Mask>(found), _mm512_loadu_si512(others));
    const int count = __builtin_popcount(found);
    store_pairs(next, slot, _mm512_castsi512_si256(other), offset);
    if (__builtin_expect(count > 8, 0)) store_pairs(next + 8, slot, _mm512_extracti64x4_epi64(other, 1), offset);
    return next + count;
  }

 private:
  static void store_pairs(hg_pair *to, uint32_t slot, __m256i other, int32_t offset) {
    const __m256i me = _mm256_set1_epi32(static_cast<int32_t>(slot)), shift = _mm256_set1_epi32(offset);
    const __m256i low = _mm256_add_epi32(_mm256_min_epi32(me, other), shift);
    const __m256i high = _mm256_add_epi32(_mm256_max_epi32(me, other), shift);
    const __m256i a = _mm256_unpacklo_epi32(low, high), b = _mm256_unpackhi_epi32(low, high);
    _mm256_storeu_si256(reinterpret_cast<__m256i *>(to), _mm256_permute2x128_si256(a, b, 0x20));
    _mm256_storeu_si256(reinterpret_cast<__m256i *>(to + 4), _mm256_permute2x128_si256(a, b, 0x31));
  }
};

}  // namespace
}  // namespace hg
