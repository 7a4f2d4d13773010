// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The knob of the skin: how far particles may move before the library searches candidates anew.
#pragma once

#include "programs/accuracy/trade.hpp"

#include <vector>

namespace accuracy {

std::vector<TradePoint> measure_run_skins(const Budget &budget, const Progress &progress);

}  // namespace accuracy
