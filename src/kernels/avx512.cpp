// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/kernels/doubles_avx512.hpp"
#include "src/kernels/kernel_set.hpp"
#include "src/kernels/lanes_avx512.hpp"
#include "src/kernels/make_kernels.hpp"
#include "src/kernels/sort_avx2.hpp"

namespace hg {

const KernelSet kAvx512Kernels = make_kernels<Avx512Lanes, Avx512Doubles, Avx2Sorter>("avx512");

}  // namespace hg
