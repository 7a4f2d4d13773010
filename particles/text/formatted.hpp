// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Text with numbers in it, in the formats of printf.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <string>

namespace particles {

[[gnu::format(printf, 1, 2)]] inline std::string formatted(const char *format, ...) {
  char text[256];
  va_list arguments;
  va_start(arguments, format);
  const int length = std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return {text, static_cast<size_t>(length) < sizeof text ? static_cast<size_t>(length) : sizeof text - 1};
}

}  // namespace particles
