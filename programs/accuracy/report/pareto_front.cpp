// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/report/pareto_front.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace accuracy {
namespace {

bool same_series(const Point &a, const Point &b) {
  return a.parameter == b.parameter && a.system == b.system && a.error_of == b.error_of;
}

// Of points with the same error the cheapest, or the default if that is no dearer.
Point best_of(const Series &series, double error) {
  Series same;
  std::copy_if(series.begin(), series.end(), std::back_inserter(same),
               [error](const Point &point) { return point.error == error; });
  const Point &best =
      *std::min_element(same.begin(), same.end(), [](const Point &a, const Point &b) { return a.cost < b.cost; });
  for (const Point &point : same) {
    if (point.is_default && point.cost <= kSameCost * best.cost) return point;
  }
  return best;
}

DigitCost cost_between(const Point &from, const Point &to) {
  if (to.error > 0) {
    const double digits = std::log10(from.error / to.error);
    return {DigitCost::Kind::kFactor, from, to, std::pow(to.cost / from.cost, 1 / digits)};
  }
  return {DigitCost::Kind::kToZero, from, to, to.cost / from.cost};
}

}  // namespace

std::vector<Series> series_of(const std::vector<Point> &points) {
  std::vector<Series> all;
  for (const Point &point : points) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Series &s) { return same_series(s[0], point); });
    if (found == all.end()) {
      all.push_back({point});
    } else {
      found->push_back(point);
    }
  }
  return all;
}

Series pareto_front(const Series &series) {
  std::set<double> errors;
  for (const Point &point : series) errors.insert(point.error);
  Series front;
  double least_cost = HUGE_VAL;  // of all points with less error
  for (const double error : errors) {
    const Point point = best_of(series, error);
    if (kSameCost * point.cost < least_cost) front.push_back(point);
    least_cost = std::min(least_cost, point.cost);
  }
  std::reverse(front.begin(), front.end());
  return front;
}

std::vector<DigitCost> costs_of_a_digit(const std::vector<Point> &points) {
  std::vector<DigitCost> costs;
  for (const Series &series : series_of(points)) {
    const Series front = pareto_front(series);
    if (front.size() == 1) costs.push_back({DigitCost::Kind::kFree, front[0], front[0], 1});
    for (size_t k = 0; k + 1 < front.size(); k++) costs.push_back(cost_between(front[k], front[k + 1]));
  }
  return costs;
}

}  // namespace accuracy
