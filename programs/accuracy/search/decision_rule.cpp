// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Varies `accuracy` of a grid, on systems of touching pairs: small ones to be held against the truth and large ones of
// the same kind to be timed.
#include "oracle/pairs.hpp"
#include "particles/text/formatted.hpp"
#include "programs/accuracy/contacts.hpp"
#include "programs/accuracy/search/studies.hpp"
#include "programs/accuracy/search/systems.hpp"
#include "programs/measure/search_timer.hpp"

namespace accuracy {
namespace {

struct Rule {
  const char *name;
  int32_t accuracy;
};
// The fastest first, as one would expect.
constexpr Rule kRules[] = {{"HG_FLOAT", HG_FLOAT}, {"HG_DOUBLE", HG_DOUBLE}, {"HG_EXACT", HG_EXACT}};

struct System {
  std::string name;
  particles::ParticleSet (*make)(size_t count);
  double offset;  // by which all are then moved
};

std::vector<System> systems_of(const Budget &budget) {
  const auto packed = [](size_t n) { return relaxed(kUniformVolume50.law, n); };
  const auto chained = [](size_t n) { return touching_chain(n, 1e6); };
  std::vector<System> systems = {{"relaxed packing, ratio 50", packed, 0},
                                 {"the same, 1e6 radii from the origin", packed, 1e6},
                                 {"the same, 1e9 radii from the origin", packed, 1e9},
                                 {"touching spheres, ratio 1e6", chained, 0},
                                 {"turned lattice, all touching", turned_lattice, 0}};
  if (budget.quick) systems.erase(systems.begin() + 1);
  return systems;
}

hg_grid_def def_of(const particles::ParticleSet &particles, int32_t accuracy) {
  hg_grid_def def = measure::def_of(particles);
  def.thread_count = 1;
  def.accuracy = accuracy;
  return def;
}

oracle::Pairs true_pairs(const particles::ParticleSet &particles) {
  return oracle::swept_pairs(measure::def_of(particles), particles, oracle::exact_interact);
}

// What moving them far from the origin does to the pairs, before any search: places are rounded more coarsely there.
std::string moving_note(const System &system, size_t count, const oracle::Pairs &truth) {
  if (system.offset == 0) return "";
  const size_t changed = oracle::difference(true_pairs(system.make(count)), truth).count();
  return "; rounding the places changed " + std::to_string(changed) + " pairs";
}

void measure_system(const System &system, Recorder &record) {
  const Budget &budget = record.budget();
  const particles::ParticleSet small = moved(system.make(budget.truth_count), system.offset),
                               large = moved(system.make(budget.timed_count), system.offset);
  const oracle::Pairs truth = true_pairs(small);
  const std::string moving = moving_note(system, budget.truth_count, truth);
  std::vector<measure::SearchTimer> timers;
  for (const Rule &rule : kRules) timers.emplace_back(def_of(large, rule.accuracy), large);
  measure::in_turns(timers, budget.repeats);
  for (size_t k = 0; k < timers.size(); k++) {
    const oracle::Difference wrong = oracle::difference(truth, found_pairs(def_of(small, kRules[k].accuracy), small));
    const std::string note =
        particles::formatted("%zu missing, %zu extra of %zu", wrong.missing.size(), wrong.extra.size(), truth.size());
    const double error = static_cast<double>(wrong.count()) / static_cast<double>(truth.size());
    record.add({kRules[k].name,
                timers[k].ns_per_particle(),
                {{"pairs wrong", error, note + moving}},
                kRules[k].accuracy == HG_EXACT});
  }
}

}  // namespace

void measure_decision_rules(Recorder &record) {
  for (const System &system : systems_of(record.budget())) {
    record.begin(system.name);
    measure_system(system, record);
  }
}

}  // namespace accuracy
