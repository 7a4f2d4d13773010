// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The kernels of each instruction set that this build holds, and the choice among them at run time.
#pragma once

#include "src/kernels/kernel.hpp"

namespace hg {

extern const KernelSet kScalarKernels;
extern const KernelSet kSse2Kernels;
extern const KernelSet kAvx2Kernels;
extern const KernelSet kAvx512Kernels;
extern const KernelSet kNeonKernels;

// The best that this machine runs, or what the environment variable HGRID_ISA names. Chosen once, at the first call.
// Throws HG_ERR_ARGUMENT if HGRID_ISA names an instruction set that is unknown, not built or not supported here.
const KernelSet &active_kernels();

}  // namespace hg
