// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Pareto fronts of measured points and the slope along them.
#include "programs/accuracy/ten_times.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace accuracy {
namespace {

bool same_series(const TradePoint &a, const TradePoint &b) {
  return a.knob == b.knob && a.system == b.system && a.error_of == b.error_of;
}

// Of points with the same error the cheapest, or the default if that is no dearer.
const TradePoint &best_of(const std::vector<TradePoint> &points, double error) {
  const TradePoint *best = nullptr;
  for (const TradePoint &point : points) {
    if (point.error == error && (best == nullptr || point.cost < best->cost)) best = &point;
  }
  for (const TradePoint &point : points) {
    if (point.error == error && point.is_default && point.cost <= kSameCost * best->cost) return point;
  }
  return *best;
}

Step step_between(const TradePoint &from, const TradePoint &to) {
  Step step;
  step.from = from;
  step.to = to;
  if (to.error > 0) {
    step.kind = Step::Kind::kFactor;
    step.factor = std::pow(to.cost / from.cost, 1 / std::log10(from.error / to.error));
  } else {
    step.kind = Step::Kind::kToZero;
    step.factor = to.cost / from.cost;
  }
  return step;
}

}  // namespace

std::vector<TradePoint> pareto_front(const std::vector<TradePoint> &points) {
  std::set<double> errors;
  for (const TradePoint &point : points) errors.insert(point.error);
  std::vector<TradePoint> front;
  double least_cost = HUGE_VAL;  // of all points with less error
  for (const double error : errors) {
    const TradePoint &point = best_of(points, error);
    if (kSameCost * point.cost < least_cost) front.push_back(point);
    least_cost = std::min(least_cost, point.cost);
  }
  std::reverse(front.begin(), front.end());
  return front;
}

std::vector<std::vector<TradePoint>> series_of(const std::vector<TradePoint> &points) {
  std::vector<std::vector<TradePoint>> all;
  for (const TradePoint &point : points) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto &s) { return same_series(s[0], point); });
    if (found == all.end()) {
      all.push_back({point});
    } else {
      found->push_back(point);
    }
  }
  return all;
}

std::vector<Step> ten_times_more(const std::vector<TradePoint> &points) {
  std::vector<Step> steps;
  for (const std::vector<TradePoint> &series : series_of(points)) {
    const std::vector<TradePoint> front = pareto_front(series);
    if (front.size() == 1) {
      Step step;
      step.from = step.to = front[0];
      steps.push_back(step);
    }
    for (size_t k = 0; k + 1 < front.size(); k++) steps.push_back(step_between(front[k], front[k + 1]));
  }
  return steps;
}

}  // namespace accuracy
