// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Failures of the engine: texts that name what is wrong and the value.
#pragma once

#include "particles/error.hpp"

#include <cstdio>
#include <string>

namespace dem {

using particles::Error;

// A number as it stands in messages.
inline std::string text(double number) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", number);
  return buffer;
}

}  // namespace dem
