// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Friction and rolling of many contacts side by side. One loop, compiled for each width of vectors; no operation is
// fused, so that all of them give the same bits.
#include "dem/kernels/rough_batch.hpp"

#include "dem/base/vectors.hpp"
#include "dem/effects/rubbing.hpp"

namespace dem {
namespace {

#ifdef __clang__
#define DEM_SIDE_BY_SIDE _Pragma("clang loop vectorize(assume_safety)")
#else
#define DEM_SIDE_BY_SIDE _Pragma("GCC ivdep")
#endif

template <int D, class Real>
[[gnu::always_inline]] inline void rub_all(RoughBatch<D, Real> &batch, const Real *const (&normal)[3], size_t count,
                                           Real step) {
  const Real *n[3] = {normal[0], normal[1], normal[2]};
  auto &columns = batch.friction;
  DEM_SIDE_BY_SIDE
  for (size_t p = 0; p < count; p++) {
    Real unit[D], velocity[3], turning[3], stretch[D], force[3] = {0, 0, 0}, moment[3] = {0, 0, 0};
    for (int k = 0; k < D; k++) unit[k] = n[k][p];
    for (int k = 0; k < D; k++) stretch[k] = columns.stretch[k][p];
    for (int k = 0; k < 3; k++) velocity[k] = batch.velocity[p].numbers[k];
    for (int k = 0; k < 3; k++) turning[k] = batch.turning[p].numbers[k];
    const Slider<Real> slider{columns.stiffness[p], columns.damping[p], columns.limit[p]};
    rub<D>(slider, unit, velocity, turning, step, stretch, force, moment);
    for (int k = 0; k < D; k++) columns.stretch[k][p] = stretch[k];
    for (int k = 0; k < D; k++) force[k] -= batch.pressing[p] * unit[k];
    for (int k = 0; k < 4; k++) batch.velocity[p].numbers[k] = k < 3 ? force[k % 3] : Real(0);
    for (int k = 0; k < 4; k++) batch.turning[p].numbers[k] = k < 3 ? moment[k % 3] : Real(0);
  }
}

template <int D, class Real>
[[gnu::always_inline]] inline void roll_all(RoughBatch<D, Real> &batch, const Real *const (&normal)[3], size_t count,
                                            Real step) {
  const Real *n[3] = {normal[0], normal[1], normal[2]};
  auto &columns = batch.rolling;
  DEM_SIDE_BY_SIDE
  for (size_t p = 0; p < count; p++) {
    Real unit[D], spin[3], stretch[D], torque[3] = {0, 0, 0};
    for (int k = 0; k < D; k++) unit[k] = n[k][p];
    for (int k = 0; k < D; k++) stretch[k] = columns.stretch[k][p];
    for (int k = 0; k < 3; k++) spin[k] = batch.spin[p].numbers[k];
    const Slider<Real> slider{columns.stiffness[p], columns.damping[p], columns.limit[p]};
    roll<D>(slider, unit, spin, batch.radius[p], step, stretch, torque);
    for (int k = 0; k < D; k++) columns.stretch[k][p] = stretch[k];
    for (int k = 0; k < 4; k++) batch.spin[p].numbers[k] = k < 3 ? torque[k % 3] : Real(0);
  }
}

template <bool rolling, int D, class Real>
[[gnu::always_inline]] inline void take_all(RoughBatch<D, Real> &batch, const Real *const (&normal)[3], size_t count,
                                            Real step) {
  rub_all(batch, normal, count, step);
  if constexpr (rolling) roll_all(batch, normal, count, step);
}

template <bool rolling, int D, class Real>
[[gnu::flatten]] void take_plain(RoughBatch<D, Real> &batch, const Real *const (&normal)[3], size_t count, Real step) {
  take_all<rolling>(batch, normal, count, step);
}

#ifdef DEM_HAS_VECTORS
template <bool rolling, int D, class Real>
DEM_AVX2 [[gnu::flatten]] void take_by_four(RoughBatch<D, Real> &batch, const Real *const (&normal)[3], size_t count,
                                            Real step) {
  take_all<rolling>(batch, normal, count, step);
}
template <bool rolling, int D, class Real>
DEM_AVX512 [[gnu::flatten]] void take_by_eight(RoughBatch<D, Real> &batch, const Real *const (&normal)[3], size_t count,
                                               Real step) {
  take_all<rolling>(batch, normal, count, step);
}
#endif

template <bool rolling, int D, class Real>
RoughKernel<D, Real> widest() {
#ifdef DEM_HAS_VECTORS
  if (usable_vectors() == Vectors::kAvx512) return &take_by_eight<rolling, D, Real>;
  if (usable_vectors() == Vectors::kAvx2) return &take_by_four<rolling, D, Real>;
#endif
  return &take_plain<rolling, D, Real>;
}

}  // namespace

template <int D, class Real>
RoughKernel<D, Real> find_rough_kernel(EffectSet effects) {
  return has(effects, kRolling) ? widest<true, D, Real>() : widest<false, D, Real>();
}

template RoughKernel<2, double> find_rough_kernel(EffectSet);
template RoughKernel<3, double> find_rough_kernel(EffectSet);
template RoughKernel<2, float> find_rough_kernel(EffectSet);
template RoughKernel<3, float> find_rough_kernel(EffectSet);

}  // namespace dem
