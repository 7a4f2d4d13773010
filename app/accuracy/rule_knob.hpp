// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// The knob `accuracy` of a grid: how overlap is decided.
#ifndef APP_ACCURACY_RULE_KNOB_HPP
#define APP_ACCURACY_RULE_KNOB_HPP

#include "accuracy/trade.hpp"
#include "particles/particle_set.hpp"
#include "truth/difference.hpp"

#include <cstdint>
#include <vector>

namespace accuracy {

// HG_FLOAT, HG_DOUBLE and HG_EXACT against the truth in whole numbers.
std::vector<TradePoint> measure_rules(const Budget &budget, const Progress &progress);

// The pairs that the library finds at this accuracy, in any order.
oracle::Pairs found_pairs(const app::ParticleSet &particles, std::int32_t accuracy);

}  // namespace accuracy

#endif
