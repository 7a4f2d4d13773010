// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Finds the pair kernel of a scene in the tables of its boundary.
#include "dem/kernels/pair_kernels.hpp"

namespace dem {

template <int D, class Real>
PairKernel<D, Real> find_pair_kernel(EffectSet effects) {
  require_possible(effects);
  const EffectSet law = effects & kLawEffects;
  PairKernel<D, Real> kernel = nullptr;
  if (has(effects, kShear)) {
    kernel = pair_kernel_sheared<D, Real>(law);
  } else if (has(effects, kPeriodic)) {
    kernel = pair_kernel_periodic<D, Real>(law);
  } else {
    kernel = pair_kernel_open<D, Real>(law);
  }
  if (kernel == nullptr) refuse_unbuilt(effects & kPairEffects);
  return kernel;
}

template PairKernel<2, double> find_pair_kernel(EffectSet);
template PairKernel<3, double> find_pair_kernel(EffectSet);
template PairKernel<2, float> find_pair_kernel(EffectSet);
template PairKernel<3, float> find_pair_kernel(EffectSet);

}  // namespace dem
