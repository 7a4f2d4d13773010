// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Work on several threads.
#pragma once

#include "threads/parallel.hpp"

#include <cstddef>

namespace dem {

// Calls work(part, first, last) for `threads` runs of 0 .. count - 1, side by side. `work` must not throw.
template <class Work>
void in_parts(int threads, size_t count, const Work &work) {
  const auto parts = static_cast<size_t>(threads);
  hg::parallel_for(threads, parts, [&](size_t part, int) {
    work(static_cast<int>(part), count * part / parts, count * (part + 1) / parts);
  });
}

}  // namespace dem
