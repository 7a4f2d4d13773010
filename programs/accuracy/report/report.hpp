// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// All that `hgrid accuracy` says of measured points.
#pragma once

#include "programs/accuracy/report/tables.hpp"

#include <string>
#include <vector>

namespace accuracy {

// The laws of errors that follow any, what ten times more accuracy costs, and a table for each study. Points that
// follow laws are many: a row for each law says more than theirs.
std::string report(const std::vector<Study> &studies, const std::vector<Point> &points, Style style);

}  // namespace accuracy
