// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What is said when something is refused.
#pragma once

#include "particles/error.hpp"

#include <cstdio>
#include <string>

namespace test {

// What `action` is refused with; empty if it is not refused.
template <class Action>
std::string error_of(Action &&action) {
  try {
    action();
  } catch (const particles::Error &error) {
    return error.what();
  }
  return "";
}

// Whether `action` is refused with a text that holds `part`; what else it says is printed.
template <class Action>
bool is_refused(const std::string &part, Action &&action) {
  const std::string error = error_of(action);
  if (!error.empty() && error.find(part) != std::string::npos) return true;
  std::fprintf(stderr, "refused with '%s' instead of '%s'\n", error.c_str(), part.c_str());
  return false;
}

}  // namespace test
