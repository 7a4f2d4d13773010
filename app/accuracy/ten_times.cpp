// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// Pareto fronts of measured points and the slope along them.
#include "accuracy/ten_times.hpp"

#include <algorithm>
#include <cmath>

namespace accuracy {
namespace {

bool same_series(const TradePoint &a, const TradePoint &b) {
  return a.knob == b.knob && a.system == b.system && a.error_of == b.error_of;
}

// Costs that differ by no more than the noise of timing do not decide: only a point with more error can then be beaten.
bool beats(const TradePoint &a, const TradePoint &b) {
  if (a.error < b.error) return a.cost <= kSameCost * b.cost;
  return a.error == b.error && a.cost < b.cost;
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

std::vector<TradePoint> pareto_front(std::vector<TradePoint> points) {
  std::stable_sort(points.begin(), points.end(), [](const TradePoint &a, const TradePoint &b) {
    return a.error != b.error ? a.error > b.error : a.cost < b.cost;
  });
  std::vector<TradePoint> front;
  for (const TradePoint &point : points) {
    const auto better = [&](const TradePoint &other) { return beats(other, point); };
    const bool twin = !front.empty() && front.back().error == point.error;
    if (!twin && std::none_of(points.begin(), points.end(), better)) front.push_back(point);
  }
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
    for (std::size_t k = 0; k + 1 < front.size(); ++k) steps.push_back(step_between(front[k], front[k + 1]));
  }
  return steps;
}

}  // namespace accuracy
