// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_dem: whole steps of a scene of elastic spheres, by the engine of `hgrid run`, by the paper's method in plain
// code, and by LAMMPS. Exit code 0 only if all move the particles alike.
#include "programs/bench/dem/step_results.hpp"
#include "programs/bench/dem/stepper.hpp"
#include "programs/bench/library_searches.hpp"
#include "programs/bench/machine.hpp"
#include "programs/bench/program.hpp"

#include <CLI/CLI.hpp>
#include <fnmatch.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace {

struct Options {
  std::vector<std::string> scenes;
  std::string sweep, csv;
  bench::Settling settling;
  bench::StepEffort effort;
  std::vector<int> levels;
  std::vector<double> skins{0.1, 0.2, 0.4, 0.8};
  std::vector<std::string> only;
  bool keep_state = false, settle_only = false;
};

using Contestants = std::vector<bench::StepContestant>;

void add_engine_with_skins(const Options &options, const std::string &isa, int threads, Contestants &list) {
  for (const double skin : options.skins) list.push_back(bench::engine_steps({threads, skin, 0, true}, isa));
}

Contestants programs(const Options &options, const std::string &isa) {
  Contestants list{bench::engine_steps({}, isa)};
  add_engine_with_skins(options, isa, 1, list);
  add_engine_with_skins(options, isa, 2, list);
  for (const double skin : options.skins) list.push_back(bench::loop_steps({1, skin, 0, true}, isa));
  list.push_back(bench::plain_steps(0));
#ifdef HGRID_PEER_LAMMPS
  for (const int collections : {0, 2, 3, 4, 6}) {
    for (const double skin : options.skins) list.push_back(bench::lammps_steps({1, skin, 0, true}, collections));
  }
#endif
  return list;
}

Contestants each_level_count(const Options &options, const std::string &isa) {
  Contestants list;
  for (const int count : options.levels) {
    list.push_back(bench::engine_steps({1, 0, count, false}, isa));
    list.push_back(bench::plain_steps(count));
    list.push_back(bench::hashed_steps(count));
  }
  return list;
}

Contestants each_size(const Options &options, const std::string &isa) {
  Contestants list{bench::engine_steps({}, isa), bench::plain_steps(0), bench::hashed_steps(0)};
  add_engine_with_skins(options, isa, 1, list);
  return list;
}

Contestants contestants_of(const Options &options, const std::string &isa) {
  Contestants list = options.sweep == "levels" ? each_level_count(options, isa)
                     : options.sweep == "size" ? each_size(options, isa)
                                               : programs(options, isa);
  const auto unwanted = [&](const bench::StepContestant &who) {
    const std::string key = who.name + '/' + std::to_string(who.threads);
    return !options.only.empty() && std::none_of(options.only.begin(), options.only.end(), [&](const auto &pattern) {
      return fnmatch(pattern.c_str(), key.c_str(), 0) == 0;
    });
  };
  list.erase(std::remove_if(list.begin(), list.end(), unwanted), list.end());
  if (list.empty()) throw CLI::ValidationError("--only", "no program matches");
  return list;
}

// True if all contestants that were measured through moved the particles alike.
bool report(const bench::StepMeasurement &measurement) {
  print(measurement);
  bool good = true;
  for (const bench::StepResult &result : measurement.results) {
    if (!result.chosen || result.fault.empty()) continue;
    std::printf("%s %s: %s\n", result.contestant.name.c_str(), result.contestant.variant.c_str(), result.fault.c_str());
    good = false;
  }
  if (good) std::printf("all move the particles alike\n");
  return good;
}

int compare(const Options &options) {
  if (options.sweep == "levels" && options.levels.empty()) throw CLI::ValidationError("--sweep", "needs --levels");
  std::printf("%s, %d processors; %s; commit %s\n", bench::processor().c_str(), bench::processor_count(),
              bench::compiler().c_str(), bench::commit());
  const std::string isa = bench::usable_instruction_sets().front();
  std::vector<bench::StepMeasurement> measurements;
  bool good = true;
  for (const std::string &scene : options.scenes) {
    const bench::SettledSystem system = bench::settle(scene, options.settling, options.keep_state);
    std::printf("%s: settled in %llu steps, %.2g collisions per particle\n", scene.c_str(),
                static_cast<unsigned long long>(system.steps), system.collisions);
    if (options.settle_only) continue;
    const auto [smallest, largest] = std::minmax_element(system.setup.radii.begin(), system.setup.radii.end());
    bench::StepMeasurement measurement;
    measurement.sweep = options.sweep;
    measurement.system = system.name;
    measurement.size_ratio = *largest / *smallest;
    measurement.particles = system.setup.count();
    measurement.collisions = system.collisions;
    measurement.results = bench::run_step_rounds(system, contestants_of(options, isa), options.effort);
    good = report(measurement) && good;
    measurements.push_back(std::move(measurement));
    if (!options.csv.empty()) write_csv(options.csv, measurements);
  }
  if (good) return 0;
  std::fprintf(stderr, "hgrid_dem: the programs do not move the particles alike\n");
  return 1;
}

void add_options(CLI::App &command, Options &options) {
  command.add_option("SCENE", options.scenes, "Scenes of elastic spheres between walls")->required();
  command
      .add_option("--sweep", options.sweep,
                  "levels: engine and plain code with each of --levels, a search in each step; size: both with the "
                  "levels they choose")
      ->check(CLI::IsMember({"levels", "size"}));
  command.add_option("--levels", options.levels, "Numbers of levels")->delimiter(',')->check(CLI::Range(1, 64));
  command.add_option("--skins", options.skins, "Skins to try, over the smallest radius; the fastest counts")
      ->delimiter(',')
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--collisions", options.settling.collisions, "Collisions per particle before the measurement")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_option("--settle-steps", options.settling.most_steps, "Steps for these at most (0: no limit)");
  command.add_flag("--settle-only", options.settle_only, "Measure nothing");
  command.add_flag("--keep-state", options.keep_state,
                   "Keep the settled state beside the scene, as SCENE.state, and take it from there");
  command.add_option("--steps", options.effort.steps, "Steps of each turn")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command.add_option("--repeats", options.effort.repeats, "Turns that count")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command.add_option("--first-steps", options.effort.first_steps, "Steps before the states are compared")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  command.add_option("--turn-seconds", options.effort.turn_seconds, "Fewer steps in a turn that would take longer")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--patience", options.effort.patience, "Seconds after which a turn is given up")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--only", options.only, "Programs to measure, as patterns of NAME/THREADS (all)")->take_all();
  command.add_option("--csv", options.csv, "Also write the results to this file");
}

}  // namespace

int main(int argc, char **argv) {
  return bench::run_program("hgrid_dem", "Time whole steps of a scene in several programs and compare the motion", argc,
                            argv, add_options, compare);
}
