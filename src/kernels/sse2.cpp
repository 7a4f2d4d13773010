// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/kernels/kernel_set.hpp"
#include "src/kernels/lanes_sse2.hpp"
#include "src/kernels/make_kernels.hpp"
#include "src/kernels/sort_plain.hpp"

namespace hg {

const KernelSet kSse2Kernels = make_kernels<Sse2Lanes, NoDoubles, PlainSorter>("sse2");

}  // namespace hg
