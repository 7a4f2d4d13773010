// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Systems of touching pairs, small ones to be held against the truth and large ones of the same kind to be timed.
#include "programs/accuracy/rule_knob.hpp"

#include "oracle/particles.hpp"
#include "particles/insert.hpp"
#include "programs/accuracy/systems.hpp"
#include "programs/measure/search_timer.hpp"

#include <cstdio>
#include <memory>
#include <string>

namespace accuracy {
namespace {

struct Rule {
  const char *name;
  int32_t accuracy;
};
// The fastest first, as one would expect.
constexpr Rule kRules[] = {{"HG_FLOAT", HG_FLOAT}, {"HG_DOUBLE", HG_DOUBLE}, {"HG_EXACT", HG_EXACT}};

struct Kind {
  std::string name;
  particles::ParticleSet (*make)(size_t count);
  double offset;  // by which all are then moved
};

constexpr packing::SizeLaw kWide{packing::Law::kUniformVolume, 50, 3};

std::vector<Kind> kinds_of(const Budget &budget) {
  const auto packed = [](size_t n) { return relaxed(kWide, n); };
  const auto chained = [](size_t n) { return touching_chain(n, 1e6); };
  std::vector<Kind> kinds = {{"relaxed packing, ratio 50", packed, 0},
                             {"the same, 1e6 radii from the origin", packed, 1e6},
                             {"the same, 1e9 radii from the origin", packed, 1e9},
                             {"touching spheres, ratio 1e6", chained, 0},
                             {"turned lattice, all touching", turned_lattice, 0}};
  if (budget.quick) kinds.erase(kinds.begin() + 1);
  return kinds;
}

hg_grid_def def_of(const particles::ParticleSet &particles, int32_t accuracy) {
  hg_grid_def def = measure::def_of(particles);
  def.thread_count = 1;
  def.accuracy = accuracy;
  return def;
}

// ns per particle of each rule, in turns.
std::vector<double> costs_of(const particles::ParticleSet &particles, int repeats) {
  std::vector<std::unique_ptr<measure::SearchTimer>> timers;
  for (const Rule &rule : kRules) {
    timers.push_back(std::make_unique<measure::SearchTimer>(def_of(particles, rule.accuracy), particles));
  }
  for (int repeat = 0; repeat < repeats; repeat++) {
    for (auto &timer : timers) timer->run();
  }
  std::vector<double> costs;
  for (const auto &timer : timers)
    costs.push_back(1e9 * timer->median_seconds() / static_cast<double>(particles.count()));
  return costs;
}

oracle::Pairs truth_of(const particles::ParticleSet &particles) {
  return oracle::swept_pairs(oracle::set_of(particles));
}

size_t count_of(const oracle::Difference &wrong) { return wrong.missing.size() + wrong.extra.size(); }

// What moving them far from the origin does to the pairs, before any search: places are rounded more coarsely there.
std::string moving_note(const Kind &kind, size_t count, const oracle::Pairs &truth) {
  if (kind.offset == 0) return "";
  const oracle::Pairs at_origin = truth_of(kind.make(count));
  return "; rounding the places changed " + std::to_string(count_of(oracle::difference(at_origin, truth))) + " pairs";
}

TradePoint point_of(const Kind &kind, const Rule &rule, const oracle::Difference &wrong, size_t truth) {
  TradePoint point;
  point.knob = "accuracy";
  point.system = kind.name;
  point.setting = rule.name;
  point.error_of = "pairs wrong";
  point.error = static_cast<double>(count_of(wrong)) / static_cast<double>(truth);
  point.is_default = rule.accuracy == HG_EXACT;
  char note[80];
  std::snprintf(note, sizeof note, "%zu missing, %zu extra of %zu", wrong.missing.size(), wrong.extra.size(), truth);
  point.note = note;
  return point;
}

}  // namespace

oracle::Pairs found_pairs(const particles::ParticleSet &particles, int32_t accuracy) {
  hgrid::Grid grid(def_of(particles, accuracy));
  particles::insert(particles, grid);
  oracle::Pairs pairs;
  for (const hg_pair &pair : grid.query_pairs()) pairs.emplace_back(pair.a, pair.b);
  return pairs;
}

std::vector<TradePoint> measure_rules(const Budget &budget, const Progress &progress) {
  std::vector<TradePoint> points;
  for (const Kind &kind : kinds_of(budget)) {
    progress(kind.name);
    const particles::ParticleSet small = moved(kind.make(budget.truth_count), kind.offset);
    const oracle::Pairs truth = truth_of(small);
    const std::string moving = moving_note(kind, budget.truth_count, truth);
    const std::vector<double> costs = costs_of(moved(kind.make(budget.timed_count), kind.offset), budget.repeats);
    size_t setting = 0;
    for (const Rule &rule : kRules) {
      const oracle::Difference wrong = oracle::difference(truth, found_pairs(small, rule.accuracy));
      points.push_back(point_of(kind, rule, wrong, truth.size()));
      points.back().note += moving;
      points.back().cost = costs[setting++];
    }
  }
  return points;
}

}  // namespace accuracy
