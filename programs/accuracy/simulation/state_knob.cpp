// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The knob of the numbers that the state is kept in: float against double, in gases of two sizes.
#include "programs/accuracy/simulation/state_knob.hpp"

#include "dem/setup/time_step.hpp"
#include "programs/accuracy/simulation/elastic_gas.hpp"
#include "programs/accuracy/simulation/float_state.hpp"
#include "programs/accuracy/simulation/step_cost.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

namespace accuracy {
namespace {

constexpr int kContactsTimed = 6;
constexpr auto kUsual = static_cast<uint64_t>(dem::kUsualStepsPerContact);

TradePoint point_of(const std::string &system, dem::Precision precision, const std::string &error_of, double error,
                    const TimedRun &run) {
  TradePoint point;
  point.knob = "state";
  point.system = system;
  point.setting = precision == dem::Precision::kFloat ? "float" : "double";
  point.error_of = error_of;
  point.error = error;
  point.cost = run.ns_per_particle_and_step();
  point.is_default = precision == dem::Precision::kDouble;
  return point;
}

std::string pairs_note(const StateErrors &errors) {
  char note[80];
  std::snprintf(note, sizeof note, "%zu missed, %zu extra of %zu", errors.missed, errors.extra, errors.pairs);
  return note;
}

std::string bytes_note(TimedRun &run, size_t count) {
  char note[80];
  std::snprintf(note, sizeof note, "%.1f bytes per particle",
                static_cast<double>(run.engine().state_bytes()) / static_cast<double>(count));
  return note;
}

void add_states(const dem::Setup &setup, int rounds, std::vector<TradePoint> &points) {
  TimedRun fine(setup, dem::Precision::kDouble, kUsual), coarse(setup, dem::Precision::kFloat, kUsual);
  const StateErrors errors = compare_states(setup, fine.engine(), coarse.engine());
  for (int round = 0; round < rounds; round++) {
    fine.run(kContactsTimed * kUsual);
    coarse.run(kContactsTimed * kUsual);
  }
  char name[80];
  std::snprintf(name, sizeof name, "%zu spheres, box of %.0f radii", setup.count(), setup.box_max[0]);
  const double pairs = static_cast<double>(errors.missed + errors.extra) / static_cast<double>(errors.pairs);
  for (const dem::Precision precision : {dem::Precision::kDouble, dem::Precision::kFloat}) {
    const bool exact = precision == dem::Precision::kDouble;
    TimedRun &run = exact ? fine : coarse;
    const auto add = [&](const char *error_of, double error, const std::string &note) {
      points.push_back(point_of(name, precision, error_of, exact ? 0 : error, run));
      points.back().note = note;
    };
    add("pairs after one t_c", pairs, exact ? "" : pairs_note(errors));
    add("overlaps after one t_c", errors.overlap, bytes_note(run, setup.count()));
    add("largest overlap after one t_c", errors.largest_overlap, "");
    add("energy after one t_c", errors.energy, "");
  }
}

}  // namespace

std::vector<TradePoint> measure_states(const Budget &budget, const Progress &progress) {
  std::vector<TradePoint> points;
  const int rounds = std::min(budget.repeats, 3);
  for (const size_t count : {size_t{4096}, budget.timed_count}) {
    progress(std::to_string(count) + " spheres");
    add_states(melted_gas(timed_gas(count)), rounds, points);
  }
  return points;
}

}  // namespace accuracy
