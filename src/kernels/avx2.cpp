// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "kernel_sets.hpp"
#include "lanes_avx2.hpp"
#include "make_kernels.hpp"

namespace hg {

const KernelSet kAvx2Kernels = make_kernels<Avx2Lanes>("avx2");

}  // namespace hg
