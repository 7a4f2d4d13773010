// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The knob of the integration scheme and its time step.
#pragma once

#include "programs/accuracy/trade.hpp"

#include <vector>

namespace accuracy {

std::vector<TradePoint> measure_steps(const Budget &budget, const Progress &progress);

}  // namespace accuracy
