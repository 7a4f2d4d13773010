// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "dem/base/vectors.hpp"

#include <cstdlib>
#include <string_view>

namespace dem {

Vectors usable_vectors() {
#ifdef DEM_HAS_VECTORS
  const char *variable = std::getenv("HGRID_ISA");
  const std::string_view wanted = variable != nullptr ? variable : "";
  const auto allows = [&](std::string_view set) { return wanted.empty() || wanted == set; };
  const bool avx512 =
      __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq");
  if (allows("avx512") && avx512) return Vectors::kAvx512;
  if (allows("avx2") && __builtin_cpu_supports("avx2")) return Vectors::kAvx2;
#endif
  return Vectors::kPlain;
}

}  // namespace dem
