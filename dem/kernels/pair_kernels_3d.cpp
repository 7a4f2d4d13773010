// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Compiles the pair kernels in three dimensions.
#include "dem/kernels/pair_kernel.hpp"

namespace dem {

template ContactKernel<3, double> find_pair_kernel(EffectSet);
template ContactKernel<3, float> find_pair_kernel(EffectSet);

}  // namespace dem
