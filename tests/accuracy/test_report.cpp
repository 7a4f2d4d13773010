// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Fronts, their slopes, their picture and their file, on made-up points whose answer is known.
#include "programs/accuracy/report/error_picture.hpp"
#include "programs/accuracy/report/number_picture.hpp"
#include "programs/accuracy/report/pareto_front.hpp"
#include "programs/accuracy/report/points_file.hpp"
#include "programs/accuracy/report/report.hpp"
#include "tests/support/frame.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace {

using accuracy::DigitCost;
using accuracy::Point;

Point point(const char *setting, double error, double cost, bool is_default = false) {
  Point p;
  p.parameter = "parameter";
  p.system = "system";
  p.error_of = "something";
  p.setting = setting;
  p.error = error;
  p.cost = cost;
  p.is_default = is_default;
  return p;
}

bool is_cost(const DigitCost &cost, DigitCost::Kind kind, const char *from, const char *to, double factor) {
  const bool ok = cost.kind == kind && cost.from.setting == from && cost.to.setting == to &&
                  std::fabs(cost.factor - factor) < 1e-12 * factor;
  if (!ok) std::printf("from %s to %s, factor %g\n", cost.from.setting.c_str(), cost.to.setting.c_str(), cost.factor);
  return ok;
}

// A hundred times less error for four times the cost is a factor of two for ten times less.
bool slopes_along_the_front() {
  const std::vector<DigitCost> costs = accuracy::costs_of_a_digit(
      {point("middle", 1e-3, 40), point("coarse", 1e-1, 10), point("bad", 1e-2, 50), point("exact", 0, 60)});
  return costs.size() == 2 && is_cost(costs[0], DigitCost::Kind::kFactor, "coarse", "middle", 2) &&
         is_cost(costs[1], DigitCost::Kind::kToZero, "middle", "exact", 1.5);
}

// The most accurate setting is also the cheapest, but for less than the noise of timing.
bool accuracy_can_be_free() {
  const std::vector<DigitCost> costs =
      accuracy::costs_of_a_digit({point("coarse", 1e-1, 10), point("exact", 0, 10.2), point("slow", 0, 20)});
  return costs.size() == 1 && is_cost(costs[0], DigitCost::Kind::kFree, "exact", "exact", 1);
}

// Of settings with the same error the default stands for all unless another is clearly cheaper.
bool ties_prefer_the_default() {
  const auto near = accuracy::pareto_front({point("other", 0, 10), point("default", 0, 10.2, true)});
  const auto far = accuracy::pareto_front({point("other", 0, 10), point("default", 0, 11, true)});
  return near.size() == 1 && near[0].setting == "default" && far.size() == 1 && far[0].setting == "other";
}

bool parameters_systems_and_errors_are_not_mixed() {
  Point other = point("elsewhere", 1e-5, 1);
  other.system = "other system";
  Point error = point("else", 1e-5, 1);
  error.error_of = "something else";
  const auto series = accuracy::series_of({point("a", 1, 1), other, error, point("b", 0.1, 2)});
  return series.size() == 3 && series[0].size() == 2 && series[0][1].setting == "b";
}

size_t count_of(const std::string &text, const std::string &part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) count++;
  return count;
}

// A circle for each point, another around the default, one in the legend; a line between the points of the front and
// one in the legend. A knob without points is left out.
bool the_picture_holds_all_points() {
  const accuracy::Figure figure = {
      "The title",
      "the cost",
      {{"The question",
        {"the answer"},
        [](const Point &p) { return p.parameter == "parameter"; },
        accuracy::setting_of},
       {"Not drawn", {}, [](const Point &p) { return p.parameter == "nothing"; }, accuracy::setting_of}}};
  const std::vector<Point> points = {point("a", 1e-1, 10, true), point("b", 1e-3, 40), point("c", 0, 60),
                                     point("d", 1e-2, 80)};
  const std::string picture = accuracy::error_picture(figure, points);
  return count_of(picture, "<circle") == 6 && count_of(picture, "stroke-width=\"1.5\"/>\n") == 2 + 1 &&
         count_of(picture, "fill-opacity=\"0.4\"") == 1 && count_of(picture, "The title") == 1 &&
         count_of(picture, "The question") == 1 && count_of(picture, "Not drawn") == 0;
}

// Costs are shown in the unit of the picture: twice those of a point look like those of one twice as dear.
bool a_knob_has_its_unit() {
  accuracy::Figure figure = {"", "", {{"", {}, [](const Point &) { return true; }, accuracy::setting_of, 2}}};
  const std::string twice = accuracy::error_picture(figure, {point("a", 1e-1, 10), point("b", 1e-2, 20)});
  figure.knobs[0].times = 1;
  return twice == accuracy::error_picture(figure, {point("a", 1e-1, 20), point("b", 1e-2, 40)});
}

// What changes the time alone is drawn over its numbers, all of them joined.
bool numbers_have_a_picture_of_their_own() {
  const accuracy::Study errors = {"parameter", "The title", "", nullptr},
                        numbers = {"exact", "Numbers", "", nullptr, "levels"};
  std::vector<Point> points = {point("a", 1e-1, 10), point("1 level", 0, 60, true), point("2 levels", 0, 50),
                               point("3 levels", 0, 70)};
  for (size_t k = 1; k < points.size(); k++) {
    points[k].parameter = "exact";
    points[k].number = static_cast<double>(k);
  }
  const std::string picture = accuracy::number_picture(numbers, points);
  const std::string report = accuracy::report({errors, numbers}, points, accuracy::Style::kText);
  return count_of(picture, "stroke-width=\"1.5\"/>\n") == 2 + 1 && count_of(picture, ">levels<") == 1 &&
         count_of(picture, "error") == 0 && count_of(report, "3 levels") == 1;  // in its table, not among the digits
}

bool same(const Point &a, const Point &b) {
  return a.parameter == b.parameter && a.system == b.system && a.setting == b.setting && a.error_of == b.error_of &&
         a.error == b.error && a.cost == b.cost && a.is_default == b.is_default && a.note == b.note &&
         a.number == b.number;
}

// Whatever letters they hold.
bool points_survive_a_file() {
  std::vector<Point> points = {point("plain", 1.0 / 3, 1e-7, true), point("a, \"b\", c", 0, 12)};
  points[0].note = "\"\"";
  points[1].number = -0.1;
  const std::string name = "points_" + std::to_string(getpid()) + ".csv";
  accuracy::write_points(name, points);
  const std::vector<Point> again = accuracy::read_points(name);
  std::remove(name.c_str());
  return again.size() == 2 && same(points[0], again[0]) && same(points[1], again[1]);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(passes<slopes_along_the_front>),
                              cmocka_unit_test(passes<accuracy_can_be_free>),
                              cmocka_unit_test(passes<ties_prefer_the_default>),
                              cmocka_unit_test(passes<parameters_systems_and_errors_are_not_mixed>),
                              cmocka_unit_test(passes<the_picture_holds_all_points>),
                              cmocka_unit_test(passes<a_knob_has_its_unit>),
                              cmocka_unit_test(passes<numbers_have_a_picture_of_their_own>),
                              cmocka_unit_test(passes<points_survive_a_file>)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
