// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Eight lanes: AVX2 (x86-64-v3).
#pragma once

#include "src/kernels/points.hpp"

#include <hgrid/types.h>

#include <immintrin.h>

namespace hg {
namespace {

// For each mask of 8 lanes, the lanes that are set, in order.
struct CompressTable {
  uint64_t lanes[256] = {};
  constexpr CompressTable() {
    for (unsigned mask = 0; mask < 256; mask++) {
      unsigned used = 0;
      for (uint64_t lane = 0; lane < 8; lane++) {
        if ((mask >> lane & 1u) != 0) lanes[mask] |= lane << (8 * used++);
      }
    }
  }
};
alignas(64) constexpr CompressTable kCompress;

struct Avx2Lanes {
  static constexpr uint32_t kLanes = 8;
  using Float = __m256;
  using Int = __m256i;
  using Mask = __m256i;

  static Float load(const float *p) { return _mm256_loadu_ps(p); }
  static Int load(const int32_t *p) { return _mm256_loadu_si256(reinterpret_cast<const __m256i *>(p)); }
  static Float set(float a) { return _mm256_set1_ps(a); }
  static Int set(int32_t a) { return _mm256_set1_epi32(a); }
  static Int iota() { return _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7); }

  // As in lanes_sse2.hpp.
  static Int load_points(const Point *points, const int32_t *index) {
    const auto point = [=](size_t pair) {
      return _mm_loadu_si128(reinterpret_cast<const __m128i *>(points + index[2 * pair]));
    };
    return _mm256_inserti128_si256(_mm256_castsi128_si256(point(0)), point(4), 1);
  }
  static Int low_words(Int a, Int b) { return _mm256_unpacklo_epi32(a, b); }
  static Int high_words(Int a, Int b) { return _mm256_unpackhi_epi32(a, b); }
  static Int low_doubles(Int a, Int b) { return _mm256_unpacklo_epi64(a, b); }
  static Int high_doubles(Int a, Int b) { return _mm256_unpackhi_epi64(a, b); }
  static Float as_float(Int a) { return _mm256_castsi256_ps(a); }

  static Float add(Float a, Float b) { return _mm256_add_ps(a, b); }
  static Float sub(Float a, Float b) { return _mm256_sub_ps(a, b); }
  static Float mul(Float a, Float b) { return _mm256_mul_ps(a, b); }
  static Float min(Float a, Float b) { return _mm256_min_ps(a, b); }
  static Float max(Float a, Float b) { return _mm256_max_ps(a, b); }
  static Float sqrt(Float a) { return _mm256_sqrt_ps(a); }
  static Float to_float(Int a) { return _mm256_cvtepi32_ps(a); }
  static Int truncate(Float a) { return _mm256_cvttps_epi32(a); }

  static Int add(Int a, Int b) { return _mm256_add_epi32(a, b); }
  static Int sub(Int a, Int b) { return _mm256_sub_epi32(a, b); }
  static Int mul(Int a, Int b) { return _mm256_mullo_epi32(a, b); }
  static Int bit_and(Int a, Int b) { return _mm256_and_si256(a, b); }
  static Int halve(Int a) { return _mm256_srai_epi32(a, 1); }

  static Mask less(Float a, Float b) { return _mm256_castps_si256(_mm256_cmp_ps(a, b, _CMP_LT_OQ)); }
  static Mask greater(Int a, Int b) { return _mm256_cmpgt_epi32(a, b); }
  static Mask equal(Int a, Int b) { return _mm256_cmpeq_epi32(a, b); }
  static Mask both(Mask a, Mask b) { return _mm256_and_si256(a, b); }
  static Mask either(Mask a, Mask b) { return _mm256_or_si256(a, b); }
  static Mask without(Mask a, Mask b) { return _mm256_andnot_si256(b, a); }
  static uint32_t bits(Mask a) { return static_cast<uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(a))); }
  static uint32_t count(Mask a) { return static_cast<uint32_t>(__builtin_popcount(bits(a))); }

  static int32_t first(Int a) { return _mm_cvtsi128_si32(_mm256_castsi256_si128(a)); }
  static int32_t greatest(Int a, Mask m) {
    const Int kept = _mm256_and_si256(a, m);
    __m128i g = _mm_max_epi32(_mm256_castsi256_si128(kept), _mm256_extracti128_si256(kept, 1));
    g = _mm_max_epi32(g, _mm_shuffle_epi32(g, _MM_SHUFFLE(1, 0, 3, 2)));
    g = _mm_max_epi32(g, _mm_shuffle_epi32(g, _MM_SHUFFLE(2, 3, 0, 1)));
    return _mm_cvtsi128_si32(g);
  }
  static Int gather(const uint32_t *p, Int i, Mask m) {
    return _mm256_mask_i32gather_epi32(_mm256_setzero_si256(), reinterpret_cast<const int *>(p), i, m, 4);
  }
  // Two loads instead of eight where all indices that count lie close to the first one of them.
  static Int gather_near(const uint32_t *p, Int i, Mask m) {
    const auto lane = static_cast<int32_t>(__builtin_ctz(bits(m) | 1u << kLanes));
    const int32_t base = first(_mm256_permutevar8x32_epi32(i, _mm256_set1_epi32(lane))) - 4;
    const Int from = _mm256_sub_epi32(i, _mm256_set1_epi32(base));
    const Int far = _mm256_and_si256(m, _mm256_andnot_si256(_mm256_set1_epi32(15), from));
    if (__builtin_expect(_mm256_testz_si256(far, far) == 0 || base < 0, 0)) return gather(p, i, m);
    const Int low = _mm256_permutevar8x32_epi32(load(reinterpret_cast<const int32_t *>(p + base)), from);
    const Int high = _mm256_permutevar8x32_epi32(load(reinterpret_cast<const int32_t *>(p + base + 8)), from);
    return _mm256_and_si256(m, _mm256_blendv_epi8(low, high, _mm256_cmpgt_epi32(from, _mm256_set1_epi32(7))));
  }
  static Int compressed(Int a, uint32_t mask) {
    const Int lanes = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<int64_t>(kCompress.lanes[mask])));
    return _mm256_permutevar8x32_epi32(a, lanes);
  }
  static void compress(uint32_t *to, Int a, Mask m) {
    _mm256_storeu_si256(reinterpret_cast<__m256i *>(to), compressed(a, bits(m)));
  }

  static hg_pair *emit(hg_pair *next, uint32_t slot, const uint32_t *others, uint32_t found, int32_t offset) {
    const Int me = _mm256_set1_epi32(static_cast<int32_t>(slot));
    const Int other = compressed(_mm256_loadu_si256(reinterpret_cast<const __m256i *>(others)), found);
    const Int shift = _mm256_set1_epi32(offset);
    const Int low = _mm256_add_epi32(_mm256_min_epi32(me, other), shift);
    const Int high = _mm256_add_epi32(_mm256_max_epi32(me, other), shift);
    const Int even = _mm256_unpacklo_epi32(low, high), odd = _mm256_unpackhi_epi32(low, high);
    const int count = __builtin_popcount(found);
    _mm256_storeu_si256(reinterpret_cast<__m256i *>(next), _mm256_permute2x128_si256(even, odd, 0x20));
    if (__builtin_expect(count > 4, 0)) {
      _mm256_storeu_si256(reinterpret_cast<__m256i *>(next + 4), _mm256_permute2x128_si256(even, odd, 0x31));
    }
    return next + count;
  }
};

}  // namespace
}  // namespace hg
