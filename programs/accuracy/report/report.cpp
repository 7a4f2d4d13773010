// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/report/report.hpp"

#include "programs/accuracy/report/convergence_table.hpp"

#include <algorithm>
#include <iterator>

namespace accuracy {

std::string report(const std::vector<Study> &studies, const std::vector<Point> &points, Style style) {
  std::vector<Point> others;
  std::copy_if(points.begin(), points.end(), std::back_inserter(others), [](const Point &p) { return !has_law(p); });
  std::string tables;
  for (const Study &study : studies) {
    const auto is_its = [&](const Point &point) { return point.parameter == study.name; };
    if (std::any_of(others.begin(), others.end(), is_its)) tables += study_table(study, others, style);
  }
  const std::string laws = convergence_table(points, style);
  // What has no error has no digits.
  const auto is_exact = [&](const Point &point) {
    return std::any_of(studies.begin(), studies.end(),
                       [&](const Study &s) { return s.number_of != nullptr && point.parameter == s.name; });
  };
  others.erase(std::remove_if(others.begin(), others.end(), is_exact), others.end());
  const std::string digits = others.empty() ? "" : digit_cost_table(others, style) + "\n";
  return tables.empty() ? laws : laws + digits + tables;
}

}  // namespace accuracy
