// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The laws that errors follow in the steps per contact, beside those that are derived.
#include "programs/accuracy/law_report.hpp"

#include "dem/setup/time_step.hpp"
#include "programs/accuracy/simulation/step_errors.hpp"
#include "programs/accuracy/ten_times.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace accuracy {
namespace {

std::string law_text(const PowerLaw &law) {
  char text[60];
  if (law.order == 0) return "";
  if (law.factor == 0) {
    std::snprintf(text, sizeof text, "~ n^-%g", law.order);
  } else {
    std::snprintf(text, sizeof text, "%.3g n^-%.3g", law.factor, law.order);
  }
  return text;
}

std::string verdict(const PowerLaw &expected, const PowerLaw &found) {
  if (expected.order == 0) return "";
  return std::fabs(found.order - expected.order) <= kOrderTolerance ? "agrees" : "differs";
}

// The default's step, with each scheme.
const TradePoint *usual_of(const std::vector<TradePoint> &series) {
  for (const TradePoint &point : series) {
    // "Any n" stands for n to n + 1, half-way on average.
    if (std::floor(point.number + 0.25) == dem::kUsualStepsPerContact) return &point;
  }
  return nullptr;
}

std::vector<std::string> row_of(const std::vector<TradePoint> &series) {
  std::vector<double> steps, errors;
  for (const TradePoint &point : series) {
    steps.push_back(point.number);
    errors.push_back(point.error);
  }
  const PowerLaw found = fitted_law(steps, errors);
  const PowerLaw expected = expected_law(dem::scheme_of_name(series[0].system), series[0].error_of);
  char error[32] = "", cost[32] = "", dearer[32] = "";
  if (const TradePoint *usual = usual_of(series)) {
    std::snprintf(error, sizeof error, "%.2g", usual->error);
    std::snprintf(cost, sizeof cost, "%.0f", usual->cost);
  }
  if (expected.order > 0) std::snprintf(dearer, sizeof dearer, "x %.3g", std::pow(10, 1 / found.order));
  return {series[0].error_of,
          series[0].system,
          law_text(expected),
          expected.order > 0 ? law_text(found) : "",
          verdict(expected, found),
          error,
          cost,
          dearer};
}

}  // namespace

bool has_law(const TradePoint &point) { return point.knob == "step"; }

std::string law_report(const std::vector<TradePoint> &points, Style style) {
  std::vector<TradePoint> steps;
  std::copy_if(points.begin(), points.end(), std::back_inserter(steps), has_law);
  if (steps.empty()) return "";
  std::vector<std::vector<std::string>> rows = {
      {"error of", "scheme", "derived", "measured", "orders", "error at n = 50", "ns per t_c", "ten times less costs"}};
  std::vector<std::vector<TradePoint>> all = series_of(steps);
  // By kinds of error instead of schemes.
  while (!all.empty()) {
    const std::string error_of = all.front().front().error_of;
    const auto others = std::stable_partition(
        all.begin(), all.end(), [&](const std::vector<TradePoint> &s) { return s[0].error_of == error_of; });
    std::for_each(all.begin(), others, [&](const std::vector<TradePoint> &s) { rows.push_back(row_of(s)); });
    all.erase(all.begin(), others);
  }
  const std::string about =
      "n: time steps per contact. Derived: to leading order; measured: fitted from n = 20 on; orders agree within "
      "0.15. "
      "Errors: rms over 400 collisions or over the spans of a gas. Time: ns per particle and t_c of simulated time, to "
      "which n is proportional: ten times less error costs 10^(1 / order).\n\n";
  return heading("Laws of the errors in the steps per contact", style) + about + table_of(rows, style) + "\n";
}

}  // namespace accuracy
