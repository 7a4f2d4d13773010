// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/kernels/doubles_avx2.hpp"
#include "src/kernels/kernel_set.hpp"
#include "src/kernels/lanes_avx2.hpp"
#include "src/kernels/make_kernels.hpp"
#include "src/kernels/sort_avx2.hpp"

namespace hg {

const KernelSet kAvx2Kernels = make_kernels<Avx2Lanes, Avx2Doubles, Avx2Sorter>("avx2");

}  // namespace hg
