// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "kernel_sets.hpp"
#include "lanes_scalar.hpp"
#include "make_kernels.hpp"

namespace hg {

const KernelSet kScalarKernels = make_kernels<ScalarLanes>("scalar");

}  // namespace hg
