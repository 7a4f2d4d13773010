// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The picture of measured trades: error against time, a panel for each knob and kind of error.
#pragma once

#include "programs/accuracy/trade.hpp"

#include <string>
#include <vector>

namespace accuracy {

// An SVG document. Both axes are logarithmic; points without error stand on a strip of their own.
std::string pareto_picture(const std::vector<Knob> &knobs, const std::vector<TradePoint> &points);

}  // namespace accuracy
