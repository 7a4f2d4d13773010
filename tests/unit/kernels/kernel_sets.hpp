// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The kernels of every instruction set that this machine runs, the scalar ones first.
#pragma once

#include "src/kernels/kernel_set.hpp"

#include <vector>

namespace hgtest {

inline std::vector<const hg::KernelSet *> kernel_sets() {
  std::vector<const hg::KernelSet *> sets = {&hg::kScalarKernels};
#if defined(__x86_64__)
  sets.push_back(&hg::kSse2Kernels);
  if (__builtin_cpu_supports("avx2") != 0) sets.push_back(&hg::kAvx2Kernels);
  if (__builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
      __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0) {
    sets.push_back(&hg::kAvx512Kernels);
  }
#elif defined(__aarch64__)
  sets.push_back(&hg::kNeonKernels);
#endif
  return sets;
}

}  // namespace hgtest
