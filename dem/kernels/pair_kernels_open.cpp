// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Compiles the pair kernels in open space or between walls.
#include "dem/kernels/pair_kernels.hpp"

namespace dem {

template <int D, class Real>
PairKernel<D, Real> pair_kernel_open(EffectSet law) {
  return pair_kernel_at<0, D, Real>(law);
}

template PairKernel<2, double> pair_kernel_open(EffectSet);
template PairKernel<3, double> pair_kernel_open(EffectSet);
template PairKernel<2, float> pair_kernel_open(EffectSet);
template PairKernel<3, float> pair_kernel_open(EffectSet);

}  // namespace dem
