// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where and with what a measurement was made.
#pragma once

#include <string>

namespace bench {

std::string processor();  // its model, as the system names it
int processor_count();    // that this process may use
std::string compiler();   // name, version, build type
const char *commit();     // of the source tree, with "+" if files were changed since; see commit.cmake

}  // namespace bench
