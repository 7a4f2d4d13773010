// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// The search with each number of levels that can be reached, in turns.
#include "accuracy/level_knob.hpp"

#include "accuracy/systems.hpp"
#include "measure/search_timer.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>

namespace accuracy {
namespace {

constexpr int kMostLevels = 10;
constexpr double kPatience = 0.5;  // seconds; a number of levels that has taken that long is not run again

using Timers = std::vector<std::unique_ptr<measure::SearchTimer>>;  // one for each number of levels

std::unique_ptr<measure::SearchTimer> timer_of(const app::ParticleSet &particles, int level_count) {
  hg_grid_def def = measure::def_of(particles);
  def.thread_count = 1;
  def.level_count = level_count;
  auto timer = std::make_unique<measure::SearchTimer>(def, particles);
  timer->grid().insert(particles);
  return timer;
}

Timers timers_of(const app::ParticleSet &particles) {
  Timers timers;
  for (int count = 1; count <= kMostLevels; ++count) {
    auto timer = timer_of(particles, count);
    if (timer->grid().levels().count == static_cast<std::size_t>(count)) timers.push_back(std::move(timer));
  }
  return timers;
}

void measure_system(const std::string &system, const app::ParticleSet &particles, int repeats,
                    std::vector<TradePoint> &points) {
  const Timers timers = timers_of(particles);
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (const auto &timer : timers) {
      if (repeat == 0 || timer->total_seconds() < kPatience) timer->run();
    }
  }
  const auto quicker = [](const auto &a, const auto &b) { return a->median_seconds() < b->median_seconds(); };
  const double best = (*std::min_element(timers.begin(), timers.end(), quicker))->median_seconds();
  const std::size_t chosen = timer_of(particles, 0)->grid().levels().count;
  const auto count = static_cast<double>(particles.count());
  for (const auto &timer : timers) {
    const std::size_t levels = timer->grid().levels().count;
    TradePoint point;
    point.knob = "levels";
    point.system = system;
    point.setting = std::to_string(levels) + (levels == 1 ? " level" : " levels");
    point.error_of = "time above the least";
    point.error = timer->median_seconds() / best - 1;
    point.cost = 1e9 * timer->median_seconds() / count;
    point.is_default = levels == chosen;
    char note[60];
    std::snprintf(note, sizeof note, "%.1f candidates per particle",
                  static_cast<double>(timer->grid().stats().candidate_count) / count);
    point.note = note;
    points.push_back(point);
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
