// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Checks for the unit tests: a failed one throws a text, which is printed with the seed that led to it.
#pragma once

#include "src/base/error.hpp"
#include "tests/support/frame.h"
#include "tests/support/holds.hpp"
#include "tests/support/rng.hpp"

#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

namespace hgtest {

__attribute__((format(printf, 2, 3))) inline void require(bool condition, const char *format, ...) {
  if (condition) return;
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  throw Failure(text);
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
