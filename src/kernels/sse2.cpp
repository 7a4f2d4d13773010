// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "kernel_sets.hpp"
#include "lanes_sse2.hpp"
#include "make_kernels.hpp"

namespace hg {

const KernelSet kSse2Kernels = make_kernels<Sse2Lanes>("sse2");

}  // namespace hg
