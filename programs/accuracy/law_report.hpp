// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The laws that errors follow in the steps per contact, beside those that are derived.
#pragma once

#include "programs/accuracy/report.hpp"
#include "programs/accuracy/trade.hpp"

#include <string>
#include <vector>

namespace accuracy {

// How far a measured order may be from the derived one.
constexpr double kOrderTolerance = 0.15;

// Whether law_report tells of this point.
bool has_law(const TradePoint &point);

// A row for each scheme and error among the points of the knob "step": derived and measured law, whether their orders
// agree, error and time at the usual step, and what ten times less error costs by the measured order. Errors
// without a law, a single random walk's, show no order. Empty without such points.
std::string law_report(const std::vector<TradePoint> &points, Style style);

}  // namespace accuracy
