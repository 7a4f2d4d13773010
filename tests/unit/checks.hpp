// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Checks for the unit tests: a failed one throws a text, which is printed with the seed that led to it.
//
// cmocka leaves a failed assertion by longjmp, which skips destructors. Checks therefore run inside holds() or sweep(),
// and only their verdict, a plain bool, is asserted.
#pragma once

#include "src/base/error.hpp"
#include "tests/support/frame.h"
#include "tests/support/rng.hpp"

#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace hgtest {

class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

__attribute__((format(printf, 2, 3))) inline void require(bool condition, const char *format, ...) {
  if (condition) return;
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  throw Failure(text);
}

// Runs check(seed); false, with the reason printed, if it throws.
template <class Check>
bool holds(uint64_t seed, Check &&check) {
  try {
    check(seed);
    return true;
  } catch (const std::exception &e) {
    print_message("seed %llu: %s\n", static_cast<unsigned long long>(seed), e.what());
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

// `action` must throw an hg::Error of that status whose text holds `part`.
template <class Action>
void require_refused(const char *what, hg_status status, const char *part, Action &&action) {
  try {
    action();
  } catch (const hg::Error &error) {
    require(error.status() == status, "%s: status %d instead of %d (%s)", what, static_cast<int>(error.status()),
            static_cast<int>(status), error.what());
    require(std::strstr(error.what(), part) != nullptr, "%s: \"%s\" does not name \"%s\"", what, error.what(), part);
    return;
  }
  throw Failure(std::string(what) + ": was not refused");
}

}  // namespace hgtest
