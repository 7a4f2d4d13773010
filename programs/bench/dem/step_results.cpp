// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Medians and quartiles of whole steps.
#include "programs/bench/dem/step_results.hpp"

#include "programs/bench/csv_row.hpp"
#include "programs/bench/machine.hpp"
#include "programs/measure/statistics.hpp"

#include <algorithm>
#include <cstdio>

namespace bench {
namespace {

constexpr const char *kHead =
    "sweep,system,size_ratio,particles,collisions_before,contestant,variant,isa,threads,chosen,levels,occupancy,"
    "predicted_cost,candidates_per_particle,skin,searches_per_step,steps,runs,median_ns_per_particle,"
    "min_ns_per_particle,q1_ns_per_particle,q3_ns_per_particle,steps_per_second,contacts_per_particle,energy_change,"
    "verdict,machine,processors,compiler,commit\n";

std::string verdict(const StepResult &result) { return result.fault.empty() ? "same motion" : result.fault; }

// Sorted seconds of a step.
std::vector<double> step_times(const StepResult &result) {
  std::vector<double> seconds = result.seconds;
  std::sort(seconds.begin(), seconds.end());
  return seconds;
}

void write_row(particles::Output &out, const StepMeasurement &measurement, const StepResult &result) {
  const std::vector<double> seconds = step_times(result);
  const double per_particle = 1e9 / static_cast<double>(measurement.particles);
  const auto share = [&](double s) { return seconds.empty() ? -1 : per_particle * measure::quantile(seconds, s); };
  const StepContestant &who = result.contestant;
  CsvRow row(out);
  row.text(measurement.sweep).text(measurement.system).number(measurement.size_ratio).number(measurement.particles);
  row.number(measurement.collisions).text(who.name).text(who.variant).text(who.isa).number(who.threads);
  row.number(result.chosen ? 1 : 0).known(result.details.levels).known(result.details.occupancy);
  row.known(result.details.predicted_cost).known(result.details.candidates).number(who.skin);
  row.known(result.details.searches_per_step).number(static_cast<size_t>(result.steps)).number(seconds.size());
  row.known(share(0.5)).known(share(0)).known(share(0.25)).known(share(0.75));
  row.known(seconds.empty() ? -1 : 1 / measure::quantile(seconds, 0.5));
  row.number(result.contacts).number(result.energy_change).text(verdict(result));
  row.text(processor()).number(processor_count()).text(compiler()).text(commit());
}

}  // namespace

void print(const StepMeasurement &measurement) {
  std::printf("\n%s: %zu particles, largest / smallest radius %.3g, after %.2g collisions per particle\n",
              measurement.system.c_str(), measurement.particles, measurement.size_ratio, measurement.collisions);
  std::printf("whole steps: search, forces, motion\n\n");
  std::printf("%-12s %-14s %-7s %3s %6s %5s %9s %9s %9s %9s %5s %9s %9s  %s\n", "program", "variant", "isa", "thr",
              "levels", "skin", "steps/s", "ns/part.", "min", "max", "turns", "contacts", "energy", "verdict");
  for (const StepResult &result : measurement.results) {
    if (!result.chosen) continue;
    const StepContestant &who = result.contestant;
    std::printf("%-12s %-14s %-7s %3d ", who.name.c_str(), who.variant.c_str(), who.isa.c_str(), who.threads);
    if (result.details.levels < 0) {
      std::printf("%6s ", "-");
    } else {
      std::printf("%6.0f ", result.details.levels);
    }
    const std::vector<double> seconds = step_times(result);
    if (seconds.empty()) {
      std::printf("%5.2g %s\n", who.skin, verdict(result).c_str());
      continue;
    }
    const double per_particle = 1e9 / static_cast<double>(measurement.particles);
    std::printf("%5.2g %9.4g %9.2f %9.2f %9.2f %5zu %9.4f %9.1e  %s\n", who.skin, 1 / measure::quantile(seconds, 0.5),
                per_particle * measure::quantile(seconds, 0.5), per_particle * seconds.front(),
                per_particle * seconds.back(), seconds.size(), result.contacts, result.energy_change,
                verdict(result).c_str());
  }
}

void write_csv(const std::string &path, const std::vector<StepMeasurement> &measurements) {
  particles::Output out(path);
  out << kHead;
  for (const StepMeasurement &measurement : measurements) {
    for (const StepResult &result : measurement.results) write_row(out, measurement, result);
  }
  out.close();
}

}  // namespace bench
