// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The search with each number of levels that can be reached, in turns.
#include "programs/accuracy/level_knob.hpp"

#include "particles/insert.hpp"
#include "programs/accuracy/systems.hpp"
#include "programs/measure/search_timer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace accuracy {
namespace {

constexpr int kMostLevels = 10;
constexpr double kPatience = 0.5;  // seconds; a number of levels that has taken that long is not run again

using Timers = std::vector<std::unique_ptr<measure::SearchTimer>>;  // one for each number of levels

std::unique_ptr<measure::SearchTimer> timer_of(const particles::ParticleSet &particles, int level_count) {
  hg_grid_def def = measure::def_of(particles);
  def.thread_count = 1;
  def.level_count = level_count;
  auto timer = std::make_unique<measure::SearchTimer>(def, particles);
  particles::insert(particles, timer->grid());
  return timer;
}

Timers timers_of(const particles::ParticleSet &particles) {
  Timers timers;
  for (int count = 1; count <= kMostLevels; count++) {
    auto timer = timer_of(particles, count);
    if (timer->grid().query_levels().size() == static_cast<size_t>(count)) timers.push_back(std::move(timer));
  }
  return timers;
}

TradePoint point_of(const std::string &system, measure::SearchTimer &timer, measure::SearchTimer &best, double count) {
  const auto levels = static_cast<double>(timer.grid().query_levels().size());
  const auto best_levels = static_cast<double>(best.grid().query_levels().size());
  TradePoint point;
  point.knob = "levels";
  point.system = system;
  point.setting = std::to_string(timer.grid().query_levels().size()) + (levels > 1 ? " levels" : " level");
  point.error_of = "levels off the best number";
  point.error = std::fabs(levels - best_levels) / best_levels;
  point.cost = 1e9 * timer.median_seconds() / count;
  char note[100];
  std::snprintf(note, sizeof note, "%.0f %% above the least time, %.1f candidates per particle",
                100 * (timer.median_seconds() / best.median_seconds() - 1),
                static_cast<double>(timer.grid().get_stats().candidate_count) / count);
  point.note = note;
  return point;
}

void measure_system(const std::string &system, const particles::ParticleSet &particles, int repeats,
                    std::vector<TradePoint> &points) {
  const Timers timers = timers_of(particles);
  for (int repeat = 0; repeat < repeats; repeat++) {
    for (const auto &timer : timers) {
      if (repeat == 0 || timer->total_seconds() < kPatience) timer->run();
    }
  }
  const auto quicker = [](const auto &a, const auto &b) { return a->median_seconds() < b->median_seconds(); };
  measure::SearchTimer &best = **std::min_element(timers.begin(), timers.end(), quicker);
  const size_t chosen = timer_of(particles, 0)->grid().query_levels().size();
  for (const auto &timer : timers) {
    points.push_back(point_of(system, *timer, best, static_cast<double>(particles.count())));
    points.back().is_default = timer->grid().query_levels().size() == chosen;
  }
}

}  // namespace

std::vector<TradePoint> measure_level_counts(const Budget &budget, const Progress &progress) {
  using packing::Law;
  std::vector<std::pair<std::string, packing::SizeLaw>> systems = {
      {"uniform volume, ratio 50", {Law::kUniformVolume, 50, 3}},
      {"uniform volume, ratio 10", {Law::kUniformVolume, 10, 3}},
      {"uniform size, ratio 50", {Law::kUniformSize, 50, 3}}};
  if (budget.quick) systems.resize(1);
  std::vector<TradePoint> points;
  for (const auto &[name, law] : systems) {
    progress(name);
    measure_system(name, relaxed(law, budget.timed_count), budget.repeats, points);
  }
  return points;
}

}  // namespace accuracy
