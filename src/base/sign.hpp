// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The sign of a double by its bits: where the host has subnormals taken for zero, `x < 0` does not see all of them.
#pragma once

#include <cstdint>
#include <cstring>

namespace hg {

// -0.0 is not negative. NaN may be either.
inline bool is_negative(double x) {
  uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof x);
  return bits > uint64_t{1} << 63;
}

}  // namespace hg
