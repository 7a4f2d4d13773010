// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Checks that throw a text which says what is wrong, and their verdict as a plain bool for assert_true: cmocka leaves a
// failed assertion by longjmp, which skips destructors.
#pragma once

#include <cstdint>
#include <cstdio>
#include <stdexcept>

namespace hgtest {

class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Runs check(seed); false, with the reason printed, if it throws.
template <class Check>
bool holds(uint64_t seed, Check &&check) {
  try {
    check(seed);
    return true;
  } catch (const std::exception &error) {
    std::fprintf(stderr, "seed %llu: %s\n", static_cast<unsigned long long>(seed), error.what());
    return false;
  }
}

// Runs check with the seeds 0 .. rounds - 1; gives up after a few failures, which tell enough.
template <class Check>
bool sweep(uint64_t rounds, Check &&check) {
  int failures = 0;
  for (uint64_t seed = 0; seed < rounds && failures < 5; seed++) failures += holds(seed, check) ? 0 : 1;
  return failures == 0;
}

}  // namespace hgtest
