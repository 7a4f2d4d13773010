// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How the cheapest levels are looked for: by bisection or on a grid, among all radii or a sample of them.
#pragma once

#include "programs/accuracy/trade.hpp"

#include <vector>

namespace accuracy {

std::vector<TradePoint> measure_optimisers(const Budget &budget, const Progress &progress);

}  // namespace accuracy
