// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Pareto fronts of measured points, and what ten times less error, one more digit, costs along them.
#pragma once

#include "programs/accuracy/point.hpp"

#include <vector>

namespace accuracy {

// Times repeat to a few per cent: a setting that costs no more than this times another's counts as no dearer.
constexpr double kSameCost = 1.03;

// Points that share parameter, system and kind of error.
using Series = std::vector<Point>;

// In the order in which they first appear.
std::vector<Series> series_of(const std::vector<Point> &points);

// The points of a series that no other point beats, the least accurate first.
Series pareto_front(const Series &series);

// From one point of a front to the next more accurate one.
struct DigitCost {
  enum class Kind {
    kFactor,  // `factor` is the factor of cost for ten times less error, interpolated in logarithms
    kToZero,  // the next setting has no error at all: `factor` is its cost over that of the one before
    kFree     // the most accurate setting is also the cheapest: `from` and `to` are that one
  };
  Kind kind = Kind::kFree;
  Point from, to;
  double factor = 1;
};

// Along the front of each series, in the order in which these first appear.
std::vector<DigitCost> costs_of_a_digit(const std::vector<Point> &points);

}  // namespace accuracy
