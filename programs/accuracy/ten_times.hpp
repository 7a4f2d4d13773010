// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What ten times more accuracy costs, from measured points.
#pragma once

#include "programs/accuracy/trade.hpp"

#include <vector>

namespace accuracy {

// Times repeat to a few per cent: a setting that costs no more than this times another's counts as no dearer.
constexpr double kSameCost = 1.03;

// From one setting to the next more accurate one, of those that no other setting beats in both.
struct Step {
  enum class Kind {
    kFactor,  // `factor` is the factor of cost for ten times less error, interpolated in logarithms
    kToZero,  // the next setting has no error at all: `factor` is its cost over that of the one before
    kFree     // the most accurate setting is also the cheapest: `from` and `to` are that one
  };
  Kind kind = Kind::kFree;
  TradePoint from, to;
  double factor = 1;
};

// The points of one knob, system and kind of error that no other point beats, the least accurate first.
std::vector<TradePoint> pareto_front(const std::vector<TradePoint> &points);

// The steps along the front of each knob, system and kind of error, in the order in which these first appear.
std::vector<Step> ten_times_more(const std::vector<TradePoint> &points);

// Points that share knob, system and kind of error, in the order in which these first appear.
std::vector<std::vector<TradePoint>> series_of(const std::vector<TradePoint> &points);

}  // namespace accuracy
