// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Wraps blocks of positions into a periodic box, one source for all instruction sets.
#pragma once

#include "src/base/interval.hpp"
#include "src/exact/domain.hpp"

#include <cstddef>

namespace hg {
namespace {

// On one axis; all positions of the system are within `extent`. Divisions would be a fifth of the time of building, and
// few systems leave their box by more than its length.
template <size_t Count>
void wrap_block(double (&position)[Count], double low, double length, const Interval &extent) {
  if (are_near_box(extent.least, extent.greatest, low, length)) {
    for (size_t i = 0; i < Count; i++) position[i] = near_place_in_box(position[i], low, length);
  } else {
    for (size_t i = 0; i < Count; i++) position[i] = place_in_box(position[i], low, length);
  }
}

}  // namespace
}  // namespace hg
