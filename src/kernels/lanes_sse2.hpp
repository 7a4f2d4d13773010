// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Four lanes: SSE2, which every x86-64 has.
#pragma once

#include "src/kernels/points.hpp"

#include <hgrid/types.h>

#include <emmintrin.h>

namespace hg {
namespace {

struct Sse2Lanes {
  static constexpr uint32_t kLanes = 4;
  using Float = __m128;
  using Int = __m128i;
  using Mask = __m128i;

  static Float load(const float *p) { return _mm_loadu_ps(p); }
  static Int load(const int32_t *p) { return _mm_loadu_si128(reinterpret_cast<const __m128i *>(p)); }
  static Float set(float a) { return _mm_set1_ps(a); }
  static Int set(int32_t a) { return _mm_set1_epi32(a); }
  static Int iota() { return _mm_setr_epi32(0, 1, 2, 3); }

  // Points of pairs 0, 4, 8, 12 side by side, as many as there is room for; `index` is that of pair 0, of every other
  // integer one is meant. The rest takes such quarters apart: low and high halves of each, interleaved.
  static Int load_points(const Point *points, const int32_t *index) { return load(&points[index[0]].x); }
  static Int low_words(Int a, Int b) { return _mm_unpacklo_epi32(a, b); }
  static Int high_words(Int a, Int b) { return _mm_unpackhi_epi32(a, b); }
  static Int low_doubles(Int a, Int b) { return _mm_unpacklo_epi64(a, b); }
  static Int high_doubles(Int a, Int b) { return _mm_unpackhi_epi64(a, b); }
  static Float as_float(Int a) { return _mm_castsi128_ps(a); }

  static Float add(Float a, Float b) { return _mm_add_ps(a, b); }
  static Float sub(Float a, Float b) { return _mm_sub_ps(a, b); }
  static Float mul(Float a, Float b) { return _mm_mul_ps(a, b); }
  static Float min(Float a, Float b) { return _mm_min_ps(a, b); }
  static Float max(Float a, Float b) { return _mm_max_ps(a, b); }
  static Float sqrt(Float a) { return _mm_sqrt_ps(a); }
  static Float to_float(Int a) { return _mm_cvtepi32_ps(a); }
  static Int truncate(Float a) { return _mm_cvttps_epi32(a); }

  static Int add(Int a, Int b) { return _mm_add_epi32(a, b); }
  static Int sub(Int a, Int b) { return _mm_sub_epi32(a, b); }
  static Int mul(Int a, Int b) {
    const Int even = _mm_mul_epu32(a, b), odd = _mm_mul_epu32(_mm_srli_si128(a, 4), _mm_srli_si128(b, 4));
    return _mm_unpacklo_epi32(_mm_shuffle_epi32(even, _MM_SHUFFLE(0, 0, 2, 0)),
                              _mm_shuffle_epi32(odd, _MM_SHUFFLE(0, 0, 2, 0)));
  }
  static Int bit_and(Int a, Int b) { return _mm_and_si128(a, b); }
  static Int halve(Int a) { return _mm_srai_epi32(a, 1); }

  static Mask less(Float a, Float b) { return _mm_castps_si128(_mm_cmplt_ps(a, b)); }
  static Mask greater(Int a, Int b) { return _mm_cmpgt_epi32(a, b); }
  static Mask equal(Int a, Int b) { return _mm_cmpeq_epi32(a, b); }
  static Mask both(Mask a, Mask b) { return _mm_and_si128(a, b); }
  static Mask either(Mask a, Mask b) { return _mm_or_si128(a, b); }
  static Mask without(Mask a, Mask b) { return _mm_andnot_si128(b, a); }
  static uint32_t bits(Mask a) { return static_cast<uint32_t>(_mm_movemask_ps(_mm_castsi128_ps(a))); }
  static uint32_t count(Mask a) {
    const uint32_t b = bits(a);
    return (b & 1u) + (b >> 1 & 1u) + (b >> 2 & 1u) + (b >> 3);
  }

  static int32_t first(Int a) { return _mm_cvtsi128_si32(a); }
  static int32_t greatest(Int a, Mask m) {
    alignas(16) int32_t lane[4];
    _mm_store_si128(reinterpret_cast<__m128i *>(lane), _mm_and_si128(a, m));
    int32_t g = lane[0];
    for (int k = 1; k < 4; k++) g = lane[k] > g ? lane[k] : g;
    return g;
  }
  static Int gather(const uint32_t *p, Int i, Mask m) {
    alignas(16) uint32_t at[4];
    _mm_store_si128(reinterpret_cast<__m128i *>(at), _mm_and_si128(i, m));
    return _mm_setr_epi32(static_cast<int32_t>(p[at[0]]), static_cast<int32_t>(p[at[1]]),
                          static_cast<int32_t>(p[at[2]]), static_cast<int32_t>(p[at[3]]));
  }
  static Int gather_near(const uint32_t *p, Int i, Mask m) { return gather(p, i, m); }
  static void compress(uint32_t *to, Int a, Mask m) {
    alignas(16) uint32_t lane[4];
    _mm_store_si128(reinterpret_cast<__m128i *>(lane), a);
    const uint32_t set = bits(m);
    for (int k = 0; k < 4; k++) {
      *to = lane[k];
      to += set >> k & 1u;
    }
  }

  static hg_pair *emit(hg_pair *next, uint32_t slot, const uint32_t *others, uint32_t found, int32_t offset) {
    for (int k = 0; k < 4; k++) {
      const uint32_t other = others[k];
      const uint32_t low = slot < other ? slot : other, high = slot < other ? other : slot;
      *next = {static_cast<int32_t>(low) + offset, static_cast<int32_t>(high) + offset};
      next += found >> k & 1u;
    }
    return next;
  }
};

}  // namespace
}  // namespace hg
