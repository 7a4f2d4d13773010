// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Varies the number of levels: a search with each that can be reached, in turns.
#include "particles/text/formatted.hpp"
#include "programs/accuracy/search/studies.hpp"
#include "programs/accuracy/search/systems.hpp"
#include "programs/measure/search_timer.hpp"

#include <algorithm>

namespace accuracy {
namespace {

using measure::SearchTimer;

constexpr int kMostLevels = 10;
constexpr double kPatience = 0.5;  // seconds; a number of levels that has taken that long is not run again

Finding finding_of(SearchTimer &timer, SearchTimer &best, size_t chosen, size_t count) {
  const size_t levels = timer.level_count();
  const std::string note =
      particles::formatted("%.0f %% above the least time, %.1f candidates per particle",
                           100 * (timer.ns_per_particle() / best.ns_per_particle() - 1),
                           static_cast<double>(timer.grid().get_stats().candidate_count) / static_cast<double>(count));
  return {std::to_string(levels) + (levels > 1 ? " levels" : " level"),
          timer.ns_per_particle(),
          {{"pairs", 0, note}},
          levels == chosen,
          static_cast<double>(levels)};
}

void measure_system(const particles::ParticleSet &particles, Recorder &record) {
  hg_grid_def def = measure::def_of(particles);
  def.thread_count = 1;
  hgrid::Grid chosen(def);
  particles::insert(particles, chosen);
  std::vector<SearchTimer> timers = measure::timers_by_level_count(def, particles, kMostLevels);
  measure::in_turns(timers, record.budget().repeats, kPatience);
  SearchTimer &best = *std::min_element(timers.begin(), timers.end(), [](const SearchTimer &a, const SearchTimer &b) {
    return a.ns_per_particle() < b.ns_per_particle();
  });
  for (SearchTimer &timer : timers) {
    record.add(finding_of(timer, best, chosen.query_levels().size(), particles.count()));
  }
}

}  // namespace

void measure_level_counts(Recorder &record) {
  std::vector<NamedLaw> systems = {kUniformVolume50, kUniformVolume10, kUniformSize50};
  if (record.budget().quick) systems.resize(1);
  for (const auto &[name, law] : systems) {
    record.begin(name);
    measure_system(relaxed(law, record.budget().timed_count), record);
  }
}

}  // namespace accuracy
