// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Fronts, their slopes, their picture and their file, on made-up points whose answer is known.
#include "programs/accuracy/pareto_picture.hpp"
#include "programs/accuracy/points_file.hpp"
#include "programs/accuracy/ten_times.hpp"
#include "tests/particles/cmocka_cpp.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace {

using accuracy::Step;
using accuracy::TradePoint;

TradePoint point(const char *setting, double error, double cost, bool is_default = false) {
  TradePoint p;
  p.knob = "knob";
  p.system = "system";
  p.error_of = "something";
  p.setting = setting;
  p.error = error;
  p.cost = cost;
  p.is_default = is_default;
  return p;
}

bool is_step(const Step &step, Step::Kind kind, const char *from, const char *to, double factor) {
  const bool ok = step.kind == kind && step.from.setting == from && step.to.setting == to &&
                  std::fabs(step.factor - factor) < 1e-12 * factor;
  if (!ok)
    std::printf("step from %s to %s, factor %g\n", step.from.setting.c_str(), step.to.setting.c_str(), step.factor);
  return ok;
}

// A hundred times less error for four times the cost is a factor of two for ten times less.
bool slopes_are_known() {
  const std::vector<Step> steps = accuracy::ten_times_more(
      {point("middle", 1e-3, 40), point("coarse", 1e-1, 10), point("bad", 1e-2, 50), point("exact", 0, 60)});
  return steps.size() == 2 && is_step(steps[0], Step::Kind::kFactor, "coarse", "middle", 2) &&
         is_step(steps[1], Step::Kind::kToZero, "middle", "exact", 1.5);
}

void slopes_along_the_front(void **) {
  const bool ok = slopes_are_known();
  assert_true(ok);
}

// The most accurate setting is also the cheapest, but for less than the noise of timing.
bool free_is_free() {
  const std::vector<Step> steps =
      accuracy::ten_times_more({point("coarse", 1e-1, 10), point("exact", 0, 10.2), point("slow", 0, 20)});
  return steps.size() == 1 && is_step(steps[0], Step::Kind::kFree, "exact", "exact", 1);
}

void accuracy_can_be_free(void **) {
  const bool ok = free_is_free();
  assert_true(ok);
}

// Of settings with the same error the default stands for all unless another is clearly cheaper.
bool ties_go_to_the_default() {
  const auto near = accuracy::pareto_front({point("other", 0, 10), point("default", 0, 10.2, true)});
  const auto far = accuracy::pareto_front({point("other", 0, 10), point("default", 0, 11, true)});
  return near.size() == 1 && near[0].setting == "default" && far.size() == 1 && far[0].setting == "other";
}

void ties_prefer_the_default(void **) {
  const bool ok = ties_go_to_the_default();
  assert_true(ok);
}

bool series_stay_apart() {
  TradePoint other = point("elsewhere", 1e-5, 1);
  other.system = "other system";
  TradePoint error = point("else", 1e-5, 1);
  error.error_of = "something else";
  const auto series = accuracy::series_of({point("a", 1, 1), other, error, point("b", 0.1, 2)});
  return series.size() == 3 && series[0].size() == 2 && series[0][1].setting == "b";
}

void knobs_systems_and_errors_are_not_mixed(void **) {
  const bool ok = series_stay_apart();
  assert_true(ok);
}

size_t count_of(const std::string &text, const std::string &part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) count++;
  return count;
}

// A circle for each point, another around the default, one in the legend; a line between the points of the front. A
// knob that is never wrong has no panel.
bool picture_holds_the_points() {
  const std::vector<accuracy::Knob> knobs = {{"knob", "The title", "", nullptr}, {"exact", "Not drawn", "", nullptr}};
  std::vector<TradePoint> points = {point("a", 1e-1, 10, true), point("b", 1e-3, 40), point("c", 0, 60)};
  points.push_back(point("d", 0, 5));
  points.back().knob = "exact";
  const std::string picture = accuracy::pareto_picture(knobs, points);
  const std::string front = "stroke-width=\"1.5\"/>\n";
  return count_of(picture, "<circle") == 5 && count_of(picture, front) == 2 + 1 &&
         count_of(picture, "The title") == 1 && count_of(picture, "Not drawn") == 0;
}

void the_picture_holds_all_points(void **) {
  const bool ok = picture_holds_the_points();
  assert_true(ok);
}

bool same(const TradePoint &a, const TradePoint &b) {
  return a.knob == b.knob && a.system == b.system && a.setting == b.setting && a.error_of == b.error_of &&
         a.error == b.error && a.cost == b.cost && a.is_default == b.is_default && a.note == b.note &&
         a.number == b.number;
}

// Whatever letters they hold.
bool points_survive() {
  std::vector<TradePoint> points = {point("plain", 1.0 / 3, 1e-7, true), point("a, \"b\", c", 0, 12)};
  points[0].note = "\"\"";
  points[1].number = -0.1;
  const std::string name = "points_" + std::to_string(getpid()) + ".csv";
  accuracy::write_points(name, points);
  const std::vector<TradePoint> again = accuracy::read_points(name);
  std::remove(name.c_str());
  return again.size() == 2 && same(points[0], again[0]) && same(points[1], again[1]);
}

void points_survive_a_file(void **) {
  const bool ok = points_survive();
  assert_true(ok);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(slopes_along_the_front),       cmocka_unit_test(accuracy_can_be_free),
      cmocka_unit_test(ties_prefer_the_default),      cmocka_unit_test(knobs_systems_and_errors_are_not_mixed),
      cmocka_unit_test(the_picture_holds_all_points), cmocka_unit_test(points_survive_a_file)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
