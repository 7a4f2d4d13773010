// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Batches of contacts with vectors of four doubles.
#include "dem/base/vectors.hpp"
#include "dem/kernels/vector_batch.hpp"

#ifdef DEM_HAS_VECTORS
#include <immintrin.h>

#define DEM_ENTRY DEM_AVX2
#define DEM_LANES DEM_AVX2 __attribute__((always_inline))

namespace dem {
namespace {

// For each set of hits, where the words of a vector of four come from when the hits are packed; of doubles two words.
struct Packing {
  alignas(16) int32_t words[16][4];
  alignas(32) int32_t doubles[16][8];
};

constexpr Packing make_packing() {
  Packing packing{};
  for (int hit = 0; hit < 16; hit++) {
    int count = 0;
    for (int lane = 0; lane < 4; lane++) {
      if ((hit >> lane & 1) == 0) continue;
      packing.words[hit][count] = lane;
      packing.doubles[hit][2 * count] = 2 * lane;
      packing.doubles[hit][2 * count + 1] = 2 * lane + 1;
      count++;
    }
  }
  return packing;
}

constexpr Packing kPacking = make_packing();

struct Lanes {
  using Number = __m256d;
  using Truth = __m256d;
  static constexpr size_t kCount = 4;

  DEM_LANES static Number set(double x) { return _mm256_set1_pd(x); }
  DEM_LANES static Number load(const double *from) { return _mm256_loadu_pd(from); }
  DEM_LANES static void store(double *to, Number x) { _mm256_storeu_pd(to, x); }
  DEM_LANES static Number add(Number x, Number y) { return _mm256_add_pd(x, y); }
  DEM_LANES static Number sub(Number x, Number y) { return _mm256_sub_pd(x, y); }
  DEM_LANES static Number mul(Number x, Number y) { return _mm256_mul_pd(x, y); }
  DEM_LANES static Number div(Number x, Number y) { return _mm256_div_pd(x, y); }
  DEM_LANES static Number sqrt(Number x) { return _mm256_sqrt_pd(x); }
  DEM_LANES static Truth less(Number x, Number y) { return _mm256_cmp_pd(x, y, _CMP_LT_OQ); }
  DEM_LANES static Number either(Truth truth, Number x, Number y) { return _mm256_blendv_pd(y, x, truth); }
  DEM_LANES static unsigned bits(Truth truth) { return static_cast<unsigned>(_mm256_movemask_pd(truth)); }

  DEM_LANES static void pack(unsigned hit, Number x, double *to) {
    const __m256i from = _mm256_load_si256(reinterpret_cast<const __m256i *>(kPacking.doubles[hit]));
    store(to, _mm256_castps_pd(_mm256_permutevar8x32_ps(_mm256_castpd_ps(x), from)));
  }
  // Those of places first, first + 1 ... that are hit.
  DEM_LANES static void pack_places(unsigned hit, size_t first, uint32_t *to) {
    const __m128i from = _mm_load_si128(reinterpret_cast<const __m128i *>(kPacking.words[hit]));
    _mm_storeu_si128(reinterpret_cast<__m128i *>(to), _mm_add_epi32(_mm_set1_epi32(static_cast<int>(first)), from));
  }

  // Rows of four numbers as columns.
  DEM_LANES static void turn(const __m256d (&rows)[kCount], Number &x, Number &y, Number &z, Number &touching) {
    const __m256d xz = _mm256_unpacklo_pd(rows[0], rows[1]), late_xz = _mm256_unpacklo_pd(rows[2], rows[3]);
    const __m256d yr = _mm256_unpackhi_pd(rows[0], rows[1]), late_yr = _mm256_unpackhi_pd(rows[2], rows[3]);
    x = _mm256_permute2f128_pd(xz, late_xz, 0x20);
    y = _mm256_permute2f128_pd(yr, late_yr, 0x20);
    z = _mm256_permute2f128_pd(xz, late_xz, 0x31);
    touching = _mm256_permute2f128_pd(yr, late_yr, 0x31);
  }
};

}  // namespace
}  // namespace dem

#include "dem/kernels/vector_fill.hpp"

namespace dem {

template <int D>
BatchFiller<D, double> filler_by_four(EffectSet effects) {
  return filler_of<D>(effects);
}

template BatchFiller<2, double> filler_by_four(EffectSet);
template BatchFiller<3, double> filler_by_four(EffectSet);

}  // namespace dem
#endif
