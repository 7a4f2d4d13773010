// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "kernel_sets.hpp"
#include "lanes_neon.hpp"
#include "make_kernels.hpp"

namespace hg {

const KernelSet kNeonKernels = make_kernels<NeonLanes>("neon");

}  // namespace hg
