// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Passes over all particles on several threads.
#pragma once

#include "threads/parallel.hpp"

namespace hg {

// Below this many particles, waking threads costs more than they save.
inline constexpr size_t kWorthThreads = 20000;

// Into how many tasks a pass over `count` particles is cut, so few that each may keep its result on the stack.
inline constexpr size_t kMostParts = 64;
inline size_t parts_of(size_t count) {
  constexpr size_t kLeastPart = 16384;  // particles
  const size_t parts = count / kLeastPart;
  return parts < 1 ? 1 : (parts < kMostParts ? parts : kMostParts);
}

// Calls body(begin, end) for parts of [0, count) that do not depend on the number of threads.
template <class Body>
void each_part(int threads, size_t count, Body &&body) {
  const size_t parts = parts_of(count);
  parallel_for(threads, parts, [&](size_t part, int) { body(count * part / parts, count * (part + 1) / parts); });
}

}  // namespace hg
