// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// The knob of the numbers that the state is kept in.
#ifndef APP_ACCURACY_SIMULATION_STATE_KNOB_HPP
#define APP_ACCURACY_SIMULATION_STATE_KNOB_HPP

#include "accuracy/trade.hpp"

#include <vector>

namespace accuracy {

std::vector<TradePoint> measure_states(const Budget &budget, const Progress &progress);

}  // namespace accuracy

#endif
