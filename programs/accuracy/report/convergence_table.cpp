// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/report/convergence_table.hpp"

#include "dem/setup/time_step.hpp"
#include "particles/text/formatted.hpp"
#include "programs/accuracy/report/pareto_front.hpp"
#include "programs/accuracy/simulation/error_curves.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace accuracy {
namespace {

using particles::formatted;

std::string law_text(const PowerLaw &law) {
  if (law.order == 0) return "";
  if (law.factor == 0) return formatted("~ n^-%g", law.order);
  return formatted("%.3g n^-%.3g", law.factor, law.order);
}

std::string verdict(const PowerLaw &expected, const PowerLaw &found) {
  if (expected.order == 0) return "";
  return std::fabs(found.order - expected.order) <= kOrderTolerance ? "agrees" : "differs";
}

// The default's step, with each scheme.
const Point *usual_of(const Series &series) {
  for (const Point &point : series) {
    // "Any n" stands for n to n + 1, half-way on average.
    if (std::floor(point.number + 0.25) == dem::kUsualStepsPerContact) return &point;
  }
  return nullptr;
}

std::vector<std::string> row_of(const Series &series) {
  std::vector<double> steps, errors;
  for (const Point &point : series) {
    steps.push_back(point.number);
    errors.push_back(point.error);
  }
  const PowerLaw found = fitted_law(steps, errors);
  const PowerLaw expected = expected_law(dem::scheme_of_name(series[0].system), series[0].error_of);
  const Point *usual = usual_of(series);
  return {series[0].error_of,
          series[0].system,
          law_text(expected),
          expected.order > 0 ? law_text(found) : "",
          verdict(expected, found),
          usual != nullptr ? formatted("%.2g", usual->error) : "",
          usual != nullptr ? formatted("%.0f", usual->cost) : "",
          expected.order > 0 ? formatted("x %.3g", std::pow(10, 1 / found.order)) : ""};
}

}  // namespace

bool has_law(const Point &point) { return point.parameter == "step"; }

std::string convergence_table(const std::vector<Point> &points, Style style) {
  std::vector<Point> steps;
  std::copy_if(points.begin(), points.end(), std::back_inserter(steps), has_law);
  if (steps.empty()) return "";
  std::vector<std::vector<std::string>> rows = {
      {"error of", "scheme", "derived", "measured", "orders", "error at n = 50", "ns per t_c", "ten times less costs"}};
  std::vector<Series> all = series_of(steps);
  // By kinds of error instead of schemes.
  while (!all.empty()) {
    const std::string error_of = all.front().front().error_of;
    const auto others = std::stable_partition(all.begin(), all.end(),
                                              [&](const Series &series) { return series[0].error_of == error_of; });
    std::transform(all.begin(), others, std::back_inserter(rows), row_of);
    all.erase(all.begin(), others);
  }
  const std::string about =
      "n: time steps per contact. Derived: to leading order; measured: fitted from n = 20 on; orders agree within "
      "0.15. Errors: rms over 400 collisions or over the spans of a gas. Time: ns per particle and t_c of simulated "
      "time, to which n is proportional: ten times less error costs 10^(1 / order).\n\n";
  return heading("Laws of the errors in the steps per contact", style) + about + table_of(rows, style) + "\n";
}

}  // namespace accuracy
