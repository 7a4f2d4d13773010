// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The knob `accuracy` of a grid: how overlap is decided.
#pragma once

#include "oracle/pairs.hpp"
#include "particles/particle_set.hpp"
#include "programs/accuracy/trade.hpp"

#include <cstdint>
#include <vector>

namespace accuracy {

// HG_FLOAT, HG_DOUBLE and HG_EXACT against the truth.
std::vector<TradePoint> measure_rules(const Budget &budget, const Progress &progress);

// The pairs that the library finds at this accuracy, in any order.
oracle::Pairs found_pairs(const particles::ParticleSet &particles, int32_t accuracy);

}  // namespace accuracy
