// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The picture of measured points: error against time, a panel for each parameter and kind of error.
#pragma once

#include "programs/accuracy/study.hpp"

#include <string>
#include <vector>

namespace accuracy {

// An SVG document. Both axes are logarithmic; points without error stand on a strip of their own.
std::string pareto_picture(const std::vector<Study> &studies, const std::vector<Point> &points);

}  // namespace accuracy
