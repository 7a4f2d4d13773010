// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/kernels/kernel_set.hpp"
#include "src/kernels/lanes_scalar.hpp"
#include "src/kernels/make_kernels.hpp"
#include "src/kernels/sort_plain.hpp"

namespace hg {

const KernelSet kScalarKernels = make_kernels<ScalarLanes, NoDoubles, PlainSorter>("scalar");

}  // namespace hg
