// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Error texts of the C interface in the words of FORTRAN 77: its arrays, which count from 1.
#pragma once

#include <string>

namespace hgrid::f77 {

// "radii[4] = -1 is negative" becomes "R(5) = -1 is negative", "centers[4][0]" becomes "X(5)".
std::string translated(std::string text);

}  // namespace hgrid::f77
