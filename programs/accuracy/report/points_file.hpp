// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Measured points in a CSV file.
#pragma once

#include "programs/accuracy/point.hpp"

#include <string>
#include <vector>

namespace accuracy {

// One line per point: knob (the parameter),system,setting,number,error_of,error,ns,is_default,note. Words are quoted
// where they must be.
void write_points(const std::string &path, const std::vector<Point> &points);

// Reads what write_points wrote. Throws particles::Error naming file, line and value.
std::vector<Point> read_points(const std::string &path);

}  // namespace accuracy
