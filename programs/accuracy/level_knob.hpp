// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How many levels the grid has.
#pragma once

#include "programs/accuracy/trade.hpp"

#include <vector>

namespace accuracy {

std::vector<TradePoint> measure_level_counts(const Budget &budget, const Progress &progress);

}  // namespace accuracy
