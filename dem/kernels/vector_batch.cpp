// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Batches of contacts with vectors of eight doubles. Each number comes from the same operations in the same order as in
// plain code, none of them fused, so that its bits are the same.
#include "dem/kernels/vector_batch.hpp"

#include <cstdlib>
#include <string_view>

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#define DEM_HAS_AVX512
#define DEM_AVX512 __attribute__((target("avx512f,avx512vl,avx512dq,popcnt"), always_inline)) inline
#define DEM_AVX512_ENTRY __attribute__((target("avx512f,avx512vl,avx512dq,popcnt")))
#endif

namespace dem {

#ifdef DEM_HAS_AVX512
namespace {

constexpr size_t kLanes = 8;

struct Eight {
  __m512d x, y, z, touching;
};

DEM_AVX512 __m512d joined(__m256d low, __m256d high) {
  return _mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1);
}

// x_b - x_a, y_b - y_a, z_b - z_a and r_b + r_a of eight pairs: rows are subtracted, then turned into columns.
DEM_AVX512 Eight columns(const Row<double> *places, const hg_pair *pairs) {
  const __m256d minus = _mm256_setr_pd(-0.0, -0.0, -0.0, 0.0);
  __m256d rows[kLanes];
  for (size_t k = 0; k < kLanes; k++) {
    const __m256d a = _mm256_load_pd(places[pairs[k].a].numbers), b = _mm256_load_pd(places[pairs[k].b].numbers);
    rows[k] = _mm256_add_pd(b, _mm256_xor_pd(a, minus));
  }
  const __m512d even = joined(rows[0], rows[2]), odd = joined(rows[1], rows[3]);
  const __m512d late_even = joined(rows[4], rows[6]), late_odd = joined(rows[5], rows[7]);
  const __m512d xz = _mm512_unpacklo_pd(even, odd), late_xz = _mm512_unpacklo_pd(late_even, late_odd);
  const __m512d yr = _mm512_unpackhi_pd(even, odd), late_yr = _mm512_unpackhi_pd(late_even, late_odd);
  return {_mm512_shuffle_f64x2(xz, late_xz, 0x88), _mm512_shuffle_f64x2(yr, late_yr, 0x88),
          _mm512_shuffle_f64x2(xz, late_xz, 0xdd), _mm512_shuffle_f64x2(yr, late_yr, 0xdd)};
}

// As Boundary::nearest.
template <int D>
DEM_AVX512 __m512d nearest(const Boundary<D, double> &boundary, int axis, __m512d separation) {
  const __m512d whole = _mm512_set1_pd(0x1.8p52);
  const __m512d cells = _mm512_mul_pd(separation, _mm512_set1_pd(boundary.inverse_period[axis]));
  const __m512d crossed = _mm512_sub_pd(_mm512_add_pd(cells, whole), whole);
  return _mm512_sub_pd(separation, _mm512_mul_pd(_mm512_set1_pd(boundary.period[axis]), crossed));
}

DEM_AVX512 __m512d squared(__m512d x, __m512d y, __m512d z) {
  return _mm512_add_pd(_mm512_add_pd(_mm512_mul_pd(x, x), _mm512_mul_pd(y, y)), _mm512_mul_pd(z, z));
}

// Distances and unit vectors from the separations that stand in their places.
DEM_AVX512 void normalize_batch(ContactBatch<double> &batch) {
  const __m512d zero = _mm512_setzero_pd(), one = _mm512_set1_pd(1);
  for (size_t p = 0; p < batch.count; p += kLanes) {
    const __m512d x = _mm512_loadu_pd(batch.normal[0] + p), y = _mm512_loadu_pd(batch.normal[1] + p);
    const __m512d z = _mm512_loadu_pd(batch.normal[2] + p);
    const __m512d distance = _mm512_sqrt_pd(squared(x, y, z));
    const __mmask8 apart = _mm512_cmp_pd_mask(distance, zero, _CMP_GT_OQ);
    const __m512d inverse = _mm512_maskz_div_pd(apart, one, distance);
    _mm512_storeu_pd(batch.normal[0] + p, _mm512_mask_mul_pd(one, apart, x, inverse));
    _mm512_storeu_pd(batch.normal[1] + p, _mm512_mul_pd(y, inverse));
    _mm512_storeu_pd(batch.normal[2] + p, _mm512_mul_pd(z, inverse));
    _mm512_storeu_pd(batch.distance + p, distance);
  }
}

template <EffectSet E, int D>
DEM_AVX512_ENTRY size_t fill_by_eight(const BatchTask<D, double> &task, size_t next, size_t last,
                                      ContactBatch<double> &batch) {
  const __m512d range = _mm512_set1_pd(task.range);
  const __m256i lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  size_t count = 0;
  for (; next < last && count < ContactBatch<double>::kMost; next += kLanes) {
    hg_pair end[kLanes];  // the last few and what fills them up
    const hg_pair *pairs = task.pairs + next;
    __mmask8 there = 0xff;
    if (last - next < kLanes) {
      for (size_t k = 0; k < kLanes; k++) end[k] = task.pairs[next + k < last ? next + k : next];
      pairs = end;
      there = static_cast<__mmask8>((1u << (last - next)) - 1);
    }
    Eight eight = columns(task.places, pairs);
    if constexpr (has(E, kPeriodic)) {
      eight.x = nearest(*task.boundary, 0, eight.x);
      eight.y = nearest(*task.boundary, 1, eight.y);
      if constexpr (D == 3) eight.z = nearest(*task.boundary, 2, eight.z);
    }
    const __m512d reach = _mm512_add_pd(eight.touching, range);
    const __mmask8 hit =
        _mm512_mask_cmp_pd_mask(there, squared(eight.x, eight.y, eight.z), _mm512_mul_pd(reach, reach), _CMP_LT_OQ);
    // Packed in a register and stored whole: packing into memory is far slower.
    const __m256i places = _mm256_add_epi32(_mm256_set1_epi32(static_cast<int>(next)), lanes);
    _mm256_storeu_si256(reinterpret_cast<__m256i *>(batch.place + count), _mm256_maskz_compress_epi32(hit, places));
    _mm512_storeu_pd(batch.normal[0] + count, _mm512_maskz_compress_pd(hit, eight.x));
    _mm512_storeu_pd(batch.normal[1] + count, _mm512_maskz_compress_pd(hit, eight.y));
    _mm512_storeu_pd(batch.normal[2] + count, _mm512_maskz_compress_pd(hit, eight.z));
    _mm512_storeu_pd(batch.touching + count, _mm512_maskz_compress_pd(hit, eight.touching));
    count += static_cast<size_t>(__builtin_popcount(hit));
  }
  batch.count = count;
  normalize_batch(batch);
  return next < last ? next : last;
}

bool has_eight_lanes() {
  const char *wanted = std::getenv("HGRID_ISA");
  if (wanted != nullptr && *wanted != '\0' && std::string_view(wanted) != "avx512") return false;
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq");
}

}  // namespace

template <int D>
BatchFiller<D, double> find_double_filler(EffectSet effects) {
  if (has(effects, kShear) || !has_eight_lanes()) return nullptr;
#ifndef DEM_ELASTIC_ONLY
  if (has(effects, kPeriodic)) return &fill_by_eight<kPeriodic, D>;
#endif
  return &fill_by_eight<0, D>;
}
#else
template <int D>
BatchFiller<D, double> find_double_filler(EffectSet) {
  return nullptr;
}
#endif

template BatchFiller<2, double> find_double_filler(EffectSet);
template BatchFiller<3, double> find_double_filler(EffectSet);

}  // namespace dem
