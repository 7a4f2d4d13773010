// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Measured points in a CSV file.
#pragma once

#include "programs/accuracy/trade.hpp"

#include <string>
#include <vector>

namespace accuracy {

// One line per point: knob,system,setting,number,error_of,error,ns,is_default,note. Words are quoted where they must
// be.
void write_points(const std::string &path, const std::vector<TradePoint> &points);

// Reads what write_points wrote. Throws particles::Error naming file, line and value.
std::vector<TradePoint> read_points(const std::string &path);

}  // namespace accuracy
