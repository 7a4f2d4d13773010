// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Batches of contacts with vectors of eight doubles.
#include "dem/base/vectors.hpp"
#include "dem/kernels/vector_batch.hpp"

#ifdef DEM_HAS_VECTORS
#include <immintrin.h>

#define DEM_ENTRY DEM_AVX512
#define DEM_LANES DEM_AVX512 __attribute__((always_inline))

namespace dem {
namespace {

struct Lanes {
  using Number = __m512d;
  using Truth = __mmask8;
  static constexpr size_t kCount = 8;

  DEM_LANES static Number set(double x) { return _mm512_set1_pd(x); }
  DEM_LANES static Number load(const double *from) { return _mm512_loadu_pd(from); }
  DEM_LANES static void store(double *to, Number x) { _mm512_storeu_pd(to, x); }
  DEM_LANES static Number add(Number x, Number y) { return _mm512_add_pd(x, y); }
  DEM_LANES static Number sub(Number x, Number y) { return _mm512_sub_pd(x, y); }
  DEM_LANES static Number mul(Number x, Number y) { return _mm512_mul_pd(x, y); }
  DEM_LANES static Number div(Number x, Number y) { return _mm512_div_pd(x, y); }
  DEM_LANES static Number sqrt(Number x) { return _mm512_sqrt_pd(x); }
  DEM_LANES static Truth less(Number x, Number y) { return _mm512_cmp_pd_mask(x, y, _CMP_LT_OQ); }
  DEM_LANES static Number either(Truth truth, Number x, Number y) { return _mm512_mask_blend_pd(truth, y, x); }
  DEM_LANES static unsigned bits(Truth truth) { return truth; }

  // Packed in a register and stored whole: packing into memory is far slower.
  DEM_LANES static void pack(unsigned hit, Number x, double *to) {
    store(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(hit), x));
  }
  // Those of places first, first + 1 ... that are hit.
  DEM_LANES static void pack_places(unsigned hit, size_t first, uint32_t *to) {
    const __m256i places =
        _mm256_add_epi32(_mm256_set1_epi32(static_cast<int>(first)), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    _mm256_storeu_si256(reinterpret_cast<__m256i *>(to),
                        _mm256_maskz_compress_epi32(static_cast<__mmask8>(hit), places));
  }

  // Rows of four numbers as columns.
  DEM_LANES static void turn(const __m256d (&rows)[kCount], Number &x, Number &y, Number &z, Number &touching) {
    const __m512d even = joined(rows[0], rows[2]), odd = joined(rows[1], rows[3]);
    const __m512d late_even = joined(rows[4], rows[6]), late_odd = joined(rows[5], rows[7]);
    const __m512d xz = _mm512_unpacklo_pd(even, odd), late_xz = _mm512_unpacklo_pd(late_even, late_odd);
    const __m512d yr = _mm512_unpackhi_pd(even, odd), late_yr = _mm512_unpackhi_pd(late_even, late_odd);
    x = _mm512_shuffle_f64x2(xz, late_xz, 0x88);
    y = _mm512_shuffle_f64x2(yr, late_yr, 0x88);
    z = _mm512_shuffle_f64x2(xz, late_xz, 0xdd);
    touching = _mm512_shuffle_f64x2(yr, late_yr, 0xdd);
  }

 private:
  DEM_LANES static __m512d joined(__m256d low, __m256d high) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1);
  }
};

}  // namespace
}  // namespace dem

#include "dem/kernels/vector_fill.hpp"

namespace dem {

template <int D>
BatchFiller<D, double> filler_by_eight(EffectSet effects) {
  return filler_of<D>(effects);
}

template BatchFiller<2, double> filler_by_eight(EffectSet);
template BatchFiller<3, double> filler_by_eight(EffectSet);

}  // namespace dem
#endif
