// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The level of insertion h(p) (Eq. 3) of blocks of particles, one source for all instruction sets.
#pragma once

#include <cstddef>

namespace hg {
namespace {

// The finest level that takes a radius: take(i, level, yes) for all particles i and the finest level, then for each
// coarser one with whether the finer ones are too fine for i. What is taken last holds. Numbers of levels are selected,
// not looked up, so that the compiler makes vector code of it.
template <size_t Count, class Level, class Take>
void choose_levels(const double (&radius)[Count], const Level *levels, int level_count, Take &&take) {
  const Level finest = levels[0];
  for (size_t i = 0; i < Count; i++) take(i, finest, true);
  for (int h = 1; h < level_count; h++) {
    const Level level = levels[h];
    const double limit = levels[h - 1].radius_limit;
    for (size_t i = 0; i < Count; i++) take(i, level, radius[i] > limit);
  }
}

template <class T>
void take_if(bool yes, T &to, T from) {
  to = yes ? from : to;
}

}  // namespace
}  // namespace hg
