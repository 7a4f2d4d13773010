// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Work on several threads; the only file of the simulation that knows OpenMP.
#pragma once

#include <cstddef>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace dem {

// `wanted` threads, 0 for all that the machine offers.
inline int usable_threads(int wanted) {
#ifdef _OPENMP
  return wanted > 0 ? wanted : omp_get_max_threads();
#else
  (void)wanted;
  return 1;
#endif
}

// Calls work(part, first, last) for `threads` runs of 0 .. count - 1, side by side. `work` must not throw.
template <class Work>
void in_parts(int threads, size_t count, const Work &work) {
  if (threads == 1) return work(0, size_t{0}, count);
  const auto parts = static_cast<size_t>(threads);
#ifdef _OPENMP
#pragma omp parallel for num_threads(threads) schedule(static, 1)
#endif
  for (int part = 0; part < threads; part++) {
    const auto k = static_cast<size_t>(part);
    work(part, count * k / parts, count * (k + 1) / parts);
  }
}

}  // namespace dem
