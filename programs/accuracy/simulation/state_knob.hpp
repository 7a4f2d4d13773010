// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The knob of the numbers that the state is kept in.
#pragma once

#include "programs/accuracy/trade.hpp"

#include <vector>

namespace accuracy {

std::vector<TradePoint> measure_states(const Budget &budget, const Progress &progress);

}  // namespace accuracy
