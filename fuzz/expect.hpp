// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a fuzz target claims: a claim that does not hold is a finding.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace fuzz {

inline void expect(bool holds, const char *text) {
  if (holds) return;
  std::fprintf(stderr, "finding: %s\n", text);
  std::abort();
}

}  // namespace fuzz
