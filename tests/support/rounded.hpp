// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether a double is a rational number rounded correctly.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace hgtest {

// No double is nearer to the exact number, and of two that are as near the rounded one is even. What lies half a unit
// or more above the greatest double is infinite.
inline bool is_rounded(const mpq_class &exact, double rounded) {
  if (std::isinf(rounded)) {
    const mpq_class first = mpq_class(0x1.fffffffffffffp1023) + mpq_class(0x1p970);
    return rounded > 0 ? exact >= first : exact <= -first;
  }
  const mpq_class error = abs(exact - mpq_class(rounded));
  for (const double side : {-HUGE_VAL, HUGE_VAL}) {
    const double other = std::nextafter(rounded, side);
    if (std::isinf(other)) {
      if (error >= mpq_class(0x1p970)) return false;
      continue;
    }
    const mpq_class other_error = abs(exact - mpq_class(other));
    if (other_error < error) return false;
    uint64_t bits = 0;
    std::memcpy(&bits, &rounded, sizeof bits);
    if (other_error == error && bits % 2 != 0) return false;
  }
  return true;
}

}  // namespace hgtest
