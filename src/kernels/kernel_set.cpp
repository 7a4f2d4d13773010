// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/kernels/kernel_set.hpp"

#include "src/base/error.hpp"

#include <cstdlib>
#include <cstring>

namespace hg {
namespace {

struct Choice {
  const KernelSet *kernels;
  bool supported;
};

const KernelSet &choose() {
#if defined(HGRID_X86)
  __builtin_cpu_init();
  const bool avx2 = __builtin_cpu_supports("avx2") != 0;
  const bool avx512 = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
                      __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0;
#endif
  const Choice choices[] = {
#if defined(HGRID_X86)
    {&kAvx512Kernels, avx512},
    {&kAvx2Kernels, avx2},
    {&kSse2Kernels, true},
#elif defined(HGRID_ARM64)
    {&kNeonKernels, true},
#endif
    {&kScalarKernels, true},
  };
  const char *wanted = std::getenv("HGRID_ISA");
  const bool any = wanted == nullptr || *wanted == '\0';
  for (const Choice &choice : choices) {
    if (!any && std::strcmp(wanted, choice.kernels->name) != 0) continue;
    if (choice.supported) return *choice.kernels;
    if (!any) fail(HG_ERR_ARGUMENT, "HGRID_ISA = %.40s: this machine cannot run it", wanted);
  }
  fail(HG_ERR_ARGUMENT, "HGRID_ISA = %.40s: not an instruction set of this build", wanted);
}

}  // namespace

const KernelSet &active_kernels() {
  static const KernelSet &kernels = choose();
  return kernels;
}

}  // namespace hg
