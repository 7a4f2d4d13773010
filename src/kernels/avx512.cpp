// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "kernel_sets.hpp"
#include "lanes_avx512.hpp"
#include "make_kernels.hpp"

namespace hg {

const KernelSet kAvx512Kernels = make_kernels<Avx512Lanes>("avx512");

}  // namespace hg
