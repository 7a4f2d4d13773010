// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Varies the numbers that the state is kept in: float against double, in gases of two sizes.
#include "particles/text/formatted.hpp"
#include "programs/accuracy/simulation/elastic_gas.hpp"
#include "programs/accuracy/simulation/state_errors.hpp"
#include "programs/accuracy/simulation/studies.hpp"
#include "programs/accuracy/simulation/timed_run.hpp"

#include <algorithm>

namespace accuracy {
namespace {

constexpr int kMostRounds = 3;

Finding finding_of(const char *setting, const StateErrors &errors, TimedRun &run, size_t count, bool is_default) {
  const double wrong = static_cast<double>(errors.missed + errors.extra) / static_cast<double>(errors.pairs);
  const double bytes = static_cast<double>(run.engine().state_bytes()) / static_cast<double>(count);
  const std::string pairs =
      is_default ? "" : particles::formatted("%zu missed, %zu extra of %zu", errors.missed, errors.extra, errors.pairs);
  return {setting,
          run.ns_per_step(),
          {{"pairs after one t_c", wrong, pairs},
           {"overlaps after one t_c", errors.overlap, particles::formatted("%.1f bytes per particle", bytes)},
           {"largest overlap after one t_c", errors.largest_overlap, ""},
           {"energy after one t_c", errors.energy, ""}},
          is_default};
}

}  // namespace

void measure_state_precision(Recorder &record) {
  for (const size_t count : {kTimedGasCount, record.budget().timed_count}) {
    const dem::Setup setup = melted_gas(timed_gas(count));
    record.begin(particles::formatted("%zu spheres, box of %.0f radii", setup.count(), setup.box_max[0]));
    std::vector<TimedRun> runs;
    for (const dem::Precision precision : {dem::Precision::kDouble, dem::Precision::kFloat}) {
      runs.emplace_back(setup, precision, dem::kUsualStepsPerContact);
    }
    const StateErrors errors = compare_states(setup, runs[0].engine(), runs[1].engine());
    StateErrors none;
    none.pairs = errors.pairs;
    measure::in_turns(runs, std::min(record.budget().repeats, kMostRounds));
    record.add(finding_of("double", none, runs[0], setup.count(), true));
    record.add(finding_of("float", errors, runs[1], setup.count(), false));
  }
}

}  // namespace accuracy
