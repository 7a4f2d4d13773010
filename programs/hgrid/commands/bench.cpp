// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// `hgrid bench`: the time of the search for each number of levels, beside what the cost rule predicts, or that of
// steps.
#include "particles/error.hpp"
#include "particles/insert.hpp"
#include "particles/text/output.hpp"
#include "programs/hgrid/command.hpp"
#include "programs/hgrid/commands/bench_steps.hpp"
#include "programs/hgrid/grid_options.hpp"
#include "programs/hgrid/particle_options.hpp"
#include "programs/measure/search_timer.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace command {
namespace {

struct BenchOptions {
  ParticleOptions particles;
  int repeats = 9;
  int most_levels = 12;
  int threads = 1;
  double seconds = 2;
  std::string accuracy = "exact";
  double level_price = -1, row_price = -1;  // negative: the library's own
  std::string csv;
  StepOptions steps;
};

struct Row {
  std::string name;
  measure::SearchTimer timer;
  std::optional<hg_level_cost> predicted;  // what the rule expects of that many levels

  void run() { timer.run(); }
};

struct Result {
  size_t levels = 0;
  double ns = 0, fastest_ns = 0, candidates = 0;
  size_t pairs = 0, runs = 0;
};

hg_grid_def grid_def(const BenchOptions &options, const particles::ParticleSet &particles) {
  hg_grid_def def = measure::def_of(particles);
  def.thread_count = options.threads;
  def.level_price = options.level_price;
  def.row_price = options.row_price;
  if (options.accuracy == "double") def.accuracy = HG_DOUBLE;
  if (options.accuracy == "float") def.accuracy = HG_FLOAT;
  return def;
}

// Eq. 7 with the paper's K.
double paper_cost(const hg_level_cost &cost) { return cost.level_count * (cost.occupancy + 0.3); }

// One row for each number of levels that the sizes can be split into, and one for the library's own choice. All by the
// same rule: that of the paper's Appendix A sorts the radii, which would add the same time to each row.
std::vector<Row> make_rows(const BenchOptions &options, const particles::ParticleSet &particles) {
  const hg_grid_def def = grid_def(options, particles);
  std::vector<Row> rows;
  for (measure::SearchTimer &timer : measure::timers_by_level_count(def, particles, options.most_levels)) {
    const std::optional<hg_level_cost> predicted = measure::expected_cost(timer.grid(), timer.level_count());
    rows.push_back({"asked", std::move(timer), predicted});
  }
  rows.push_back({"chosen", measure::SearchTimer(def, particles), {}});
  return rows;
}

Result result_of(Row &row, size_t count) {
  measure::SearchTimer &timer = row.timer;
  Result result;
  result.pairs = timer.pairs().size();
  result.levels = timer.level_count();
  result.ns = timer.ns_per_particle();
  result.fastest_ns =
      1e9 * *std::min_element(timer.seconds().begin(), timer.seconds().end()) / static_cast<double>(count);
  result.candidates = static_cast<double>(timer.grid().get_stats().candidate_count) / static_cast<double>(count);
  result.runs = timer.seconds().size();
  return result;
}

void print_row(const Row &row, const Result &result) {
  char paper[32] = "-", fitted[32] = "-";
  if (row.predicted) std::snprintf(paper, sizeof paper, "%.2f", paper_cost(*row.predicted));
  if (row.predicted) std::snprintf(fitted, sizeof fitted, "%.2f", row.predicted->cost);
  std::printf("%-8s %6zu %12.1f %12.1f %5zu %10s %10s %12.1f %12zu\n", row.name.c_str(), result.levels, result.ns,
              result.fastest_ns, result.runs, paper, fitted, result.candidates, result.pairs);
}

void write_csv(const std::string &path, const std::vector<Row> &rows, const std::vector<Result> &results) {
  particles::Output out(path);
  out << "rule,levels,median_ns_per_particle,fastest_ns_per_particle,runs,paper_cost,fitted_cost,"
         "candidates_per_particle,pairs\n";
  for (size_t k = 0; k < rows.size(); k++) {
    const Result &r = results[k];
    out << rows[k].name << ',' << r.levels << ',' << r.ns << ',' << r.fastest_ns << ',' << r.runs << ',';
    if (rows[k].predicted) out << paper_cost(*rows[k].predicted);
    out << ',';
    if (rows[k].predicted) out << rows[k].predicted->cost;
    out << ',' << r.candidates << ',' << r.pairs << '\n';
  }
  out.close();
}

void run_bench(const BenchOptions &options) {
  const particles::ParticleSet particles = load_particles(options.particles);
  if (particles.count() == 0) throw particles::Error(options.particles.file, 0, "no particles to time");
  if (options.steps.steps > 0) {
    bench_steps(options.steps, grid_def(options, particles), particles, options.particles.file, options.csv);
    return;
  }
  std::vector<Row> rows = make_rows(options, particles);
  measure::in_turns(rows, options.repeats, options.seconds);
  std::printf("%s: %zu particles; from double arrays in memory to the complete pair list, threads: %s\n",
              options.particles.file.c_str(), particles.count(),
              options.threads == 0 ? "all" : std::to_string(options.threads).c_str());
  std::printf(
      "paper: predicted cost L (m + K) with K = 0.3; fitted: that of the prices of levels, rows and tests, by which "
      "the\n"
      "library chooses; both in units of one test. A missing L cannot be reached\n\n");
  std::printf("%-8s %6s %12s %12s %5s %10s %10s %12s %12s\n", "", "levels", "ns/particle", "fastest", "runs", "paper",
              "fitted", "candidates", "pairs");
  std::vector<Result> results;
  for (Row &row : rows) {
    results.push_back(result_of(row, particles.count()));
    print_row(row, results.back());
  }
  if (!options.csv.empty()) write_csv(options.csv, rows, results);
}

}  // namespace

void add_bench(CLI::App &parent) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App *command = parent.add_subcommand("bench", "Time the search for each number of levels");
  add_particle_options(*command, options->particles);
  command->add_option("--repeats", options->repeats, "Runs per row; the median counts")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command->add_option("--most-levels", options->most_levels, "Largest number of levels to try")
      ->check(CLI::Range(1, static_cast<int>(HG_MAX_LEVELS)))
      ->capture_default_str();
  command->add_option("--seconds", options->seconds, "A row that has taken that long is not run again")
      ->capture_default_str();
  command->add_option("--threads", options->threads, "Threads of the search, 0 = all")->capture_default_str();
  command->add_option("--accuracy", options->accuracy, "exact, double or float")
      ->check(CLI::IsMember({"exact", "double", "float"}))
      ->capture_default_str();
  command->add_option("--steps", options->steps.steps, "Time that many steps of moving particles instead")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--skin", options->steps.skins, "Skins to time the steps with, in the unit of the file")
      ->delimiter(',')
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--displacement", options->steps.displacement, "How far the fastest particle moves in a step")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  add_price_options(*command, options->level_price, options->row_price, "Search", nullptr);
  command->add_option("--csv", options->csv, "Also write the table to this file");
  command->callback([options] { run_bench(*options); });
}

}  // namespace command
