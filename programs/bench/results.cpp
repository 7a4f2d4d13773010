// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Medians and quartiles, in ns per particle.
#include "programs/bench/results.hpp"

#include "programs/bench/csv_row.hpp"
#include "programs/bench/machine.hpp"
#include "programs/measure/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bench {
namespace {

// Sorted ns per particle; empty if nothing was measured.
std::vector<double> ns_per_particle(const Result &result, size_t particles) {
  std::vector<double> ns;
  for (const double seconds : result.seconds) ns.push_back(1e9 * seconds / static_cast<double>(particles));
  std::sort(ns.begin(), ns.end());
  return ns;
}

std::string verdict(const Result &result) { return result.fault.empty() ? "same pairs" : result.fault; }

constexpr const char *kHead =
    "sweep,system,size_ratio,particles,pairs,contestant,variant,isa,threads,chosen,levels,occupancy,predicted_cost,"
    "candidates_per_particle,skin,searches_per_step,runs,median_ns_per_particle,min_ns_per_particle,q1_ns_per_particle,"
    "q3_ns_per_particle,peak_bytes_per_particle,verdict,machine,processors,compiler,commit\n";

void write_row(particles::Output &out, const Measurement &measurement, const Result &result) {
  const std::vector<double> ns = ns_per_particle(result, measurement.particles);
  const auto share = [&ns](double s) { return ns.empty() ? -1 : measure::quantile(ns, s); };
  const Contestant &who = result.contestant;
  CsvRow row(out);
  row.text(measurement.sweep).text(measurement.system).number(measurement.size_ratio).number(measurement.particles);
  row.number(result.pairs).text(who.name).text(who.variant).text(who.isa).number(who.threads);
  row.number(result.chosen ? 1 : 0).known(result.details.levels).known(result.details.occupancy);
  row.known(result.details.predicted_cost).known(result.details.candidates).known(who.skin);
  row.known(result.details.searches_per_step).number(result.seconds.size());
  row.known(share(0.5)).known(share(0)).known(share(0.25)).known(share(0.75));
  row.known(result.peak_bytes / static_cast<double>(measurement.particles)).text(verdict(result));
  row.text(processor()).number(processor_count()).text(compiler()).text(commit());
}

}  // namespace

void print(const Measurement &measurement) {
  std::printf("\n%s: %zu particles, largest / smallest radius %.3g\n", measurement.system.c_str(),
              measurement.particles, measurement.size_ratio);
  std::printf("from double arrays in memory to the complete list of pairs, ns per particle\n\n");
  std::printf("%-12s %-18s %-7s %3s %6s %10s %9s %9s %9s %9s %5s %9s  %s\n", "search", "variant", "isa", "thr",
              "levels", "candidates", "median", "min", "q1", "q3", "runs", "bytes", "verdict");
  for (const Result &result : measurement.results) {
    if (!result.chosen) continue;
    const std::vector<double> ns = ns_per_particle(result, measurement.particles);
    const Contestant &who = result.contestant;
    std::printf("%-12s %-18s %-7s %3d ", who.name.c_str(), who.variant.c_str(), who.isa.c_str(), who.threads);
    const auto field = [](int width, int digits, double value) {
      if (value < 0) {
        std::printf("%*s ", width, "-");
      } else {
        std::printf("%*.*f ", width, digits, value);
      }
    };
    field(6, 0, result.details.levels);
    field(10, 1, result.details.candidates);
    for (const double share : {0.5, 0.0, 0.25, 0.75}) field(9, 1, ns.empty() ? -1 : measure::quantile(ns, share));
    std::printf("%5zu %9.0f  %s\n", ns.size(), result.peak_bytes / static_cast<double>(measurement.particles),
                verdict(result).c_str());
  }
}

void write_csv(const std::string &path, const std::vector<Measurement> &measurements) {
  particles::Output out(path);
  out << kHead;
  for (const Measurement &measurement : measurements) {
    for (const Result &result : measurement.results) write_row(out, measurement, result);
  }
  out.close();
}

}  // namespace bench
