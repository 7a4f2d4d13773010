// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_compare: measures the library, plain searches and other programs side by side, and checks that all find the
// same pairs. Exit code 0 only if they do.
#include "programs/bench/images.hpp"
#include "programs/bench/library_searches.hpp"
#include "programs/bench/machine.hpp"
#include "programs/bench/program.hpp"
#include "programs/bench/results.hpp"
#include "programs/bench/sweeps.hpp"
#include "programs/bench/verdict.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

struct Options {
  std::vector<std::string> sources;
  std::string beside;
  bool open = false;
  std::string sweep;
  int relaxation = 10;
  bench::Effort effort;
  std::vector<std::string> only, skip;
  std::vector<int> threads;
  std::string csv;
  bool list = false;
};

const bench::Sweep &sweep_of(const std::string &name) {
  const auto &sweeps = bench::all_sweeps();
  return *std::find_if(sweeps.begin(), sweeps.end(), [&](const bench::Sweep &sweep) { return sweep.name == name; });
}

std::vector<bench::Contestant> contestants_of(const Options &options, const bench::System &system,
                                              const std::vector<std::string> &isas) {
  auto all = chosen(sweep_of(options.sweep).contestants(system, isas), isas, options.only, options.skip);
  const auto unwanted = [&](const bench::Contestant &contestant) {
    return !options.threads.empty() &&
           std::find(options.threads.begin(), options.threads.end(), contestant.threads) == options.threads.end();
  };
  all.erase(std::remove_if(all.begin(), all.end(), unwanted), all.end());
  for (bench::Contestant &contestant : all) {
    if (contestant.name != bench::kLibrary && bench::is_periodic(system.particles))
      contestant = bench::with_images(std::move(contestant));
  }
  return all;
}

bench::System load(const Options &options, const std::string &source) {
  bench::System system = bench::load_system(source, options.relaxation);
  if (options.open) bench::open_axes(system);
  return system;
}

// Time steps end elsewhere than they begin, and there the pairs are checked.
particles::ParticleSet where_steps_end(const bench::Sweep &sweep, const particles::ParticleSet &particles) {
  const double unit = *std::min_element(particles.radii.begin(), particles.radii.end());
  return bench::moved(particles, sweep.steps, sweep.step_length * unit);
}

std::string words_about(const bench::Reference &reference) {
  std::string text = std::to_string(reference.pair_count()) + " pairs in exact arithmetic";
  if (reference.rounded() == 0) return text + ", the same in doubles";
  return text + "; plain doubles decide " + std::to_string(reference.rounded()) +
         " otherwise, which touch within rounding";
}

// A system with the pairs to be found in it.
struct Task {
  bench::System system;
  particles::ParticleSet end;  // of time steps
  std::unique_ptr<bench::Reference> reference;
};

std::unique_ptr<Task> task_of(const Options &options, const std::string &source, bool moves) {
  auto task = std::make_unique<Task>();
  task->system = load(options, source);
  if (moves) task->end = where_steps_end(sweep_of(options.sweep), task->system.particles);
  task->reference = std::make_unique<bench::Reference>(moves ? task->end : task->system.particles);
  return task;
}

class Comparison {
 public:
  explicit Comparison(const Options &options) : options_(&options), isas_(bench::usable_instruction_sets()) {
    if (!options.beside.empty()) beside_ = task_of(options, options.beside, false);
  }

  void measure(const std::string &source) {
    const std::unique_ptr<Task> task = task_of(*options_, source, sweep_of(options_->sweep).steps > 0);
    std::vector<bench::Contestant> contestants = contestants_of(*options_, task->system, isas_);
    if (contestants.empty()) throw CLI::ValidationError("--only", "no contestant matches, see --list");
    drop_those_that_gave_up(contestants);
    std::vector<bench::Entry> entries;
    if (beside_) entries.push_back(entry_of(*beside_, bench::library_search({isas_.front()})));
    for (bench::Contestant &contestant : contestants) entries.push_back(entry_of(*task, std::move(contestant)));
    const std::vector<bench::Result> results = bench::run_rounds(entries, options_->effort);
    report(*task, results);
    if (beside_) report(*beside_, results);
    if (!options_->csv.empty()) write_csv(options_->csv, measurements_);
  }

  bool good() const { return good_; }

 private:
  static bench::Entry entry_of(const Task &task, bench::Contestant contestant) {
    return {std::move(contestant), &task.system.particles, task.reference.get()};
  }

  void report(const Task &task, const std::vector<bench::Result> &results) {
    bench::Measurement measurement;
    measurement.sweep = options_->sweep;
    measurement.system = task.system.name;
    measurement.size_ratio = task.system.size_ratio();
    measurement.particles = task.system.particles.count();
    std::copy_if(results.begin(), results.end(), std::back_inserter(measurement.results),
                 [&](const bench::Result &result) { return result.particles == &task.system.particles; });
    print(measurement);
    std::printf("\n%s\n", words_about(*task.reference).c_str());
    check(measurement, *task.reference);
    measurements_.push_back(std::move(measurement));
  }

  // Along a sweep things get harder.
  void drop_those_that_gave_up(std::vector<bench::Contestant> &contestants) const {
    if (options_->sweep.empty()) return;
    const auto hopeless = [this](const bench::Contestant &c) { return gave_up_.count(key_of(c)) > 0; };
    contestants.erase(std::remove_if(contestants.begin(), contestants.end(), hopeless), contestants.end());
  }

  void check(const bench::Measurement &measurement, const bench::Reference &reference) {
    if (!reference.own_fault().empty()) {
      std::printf("the library contradicts itself: %s\n", reference.own_fault().c_str());
      good_ = false;
    }
    for (const bench::Result &result : measurement.results) {
      const std::string key = key_of(result.contestant);
      const bool is_library = result.contestant.name == bench::kLibrary;
      if (result.gave_up) {
        gave_up_.insert(key);
      } else if (result.chosen && !result.fault.empty()) {
        std::printf("%s: %s\n", key.c_str(), result.fault.c_str());
        good_ = good_ && result.broke_down && !is_library;  // not all programs can search all systems
      }
    }
    if (good_) std::printf("all searches find the pairs that they must find\n");
  }

  const Options *options_;
  std::vector<std::string> isas_;
  std::unique_ptr<Task> beside_;
  std::vector<bench::Measurement> measurements_;
  std::set<std::string> gave_up_;
  bool good_ = true;
};

void list_contestants(const Options &options) {
  const std::vector<std::string> isas = bench::usable_instruction_sets();
  for (const bench::Contestant &contestant : contestants_of(options, bench::load_system("mono:1:10", 0), isas)) {
    std::printf("%s\n", key_of(contestant).c_str());
  }
}

int compare(const Options &options) {
  if (options.list) {
    list_contestants(options);
    return 0;
  }
  const std::vector<std::string> &sources = options.sources.empty() ? sweep_of(options.sweep).sources : options.sources;
  if (sources.empty())
    throw CLI::ValidationError("SYSTEM", "name a file or LAW:RATIO:COUNT[:ARRANGEMENT], or a --sweep");
  std::printf("%s, %d processors; %s; commit %s\n", bench::processor().c_str(), bench::processor_count(),
              bench::compiler().c_str(), bench::commit());
  Comparison comparison(options);
  for (const std::string &source : sources) comparison.measure(source);
  if (comparison.good()) return 0;
  std::fprintf(stderr, "hgrid_compare: the searches do not find the same pairs\n");
  return 1;
}

void add_options(CLI::App &command, Options &options) {
  command.add_option("SYSTEM", options.sources,
                     "Particle files, or packings to be made, as LAW:RATIO:COUNT[:ARRANGEMENT], e.g. "
                     "uniform-volume:50:125001 or mono:1:125000:filaments");
  command.add_flag("--open", options.open, "Take all axes as open");
  command.add_option("--beside", options.beside,
                     "Another system, on which the library (exact, one thread) is measured in the same rounds");
  std::set<std::string> names;
  std::string help = "Measure along one axis, on systems of its own unless some are named:";
  for (const bench::Sweep &sweep : bench::all_sweeps()) {
    if (sweep.name.empty()) continue;
    names.insert(sweep.name);
    help += ' ' + sweep.name + " (" + sweep.help + ")";
  }
  command.add_option("--sweep", options.sweep, help)->check(CLI::IsMember(names));
  command.add_option("--relax", options.relaxation, "Sweeps that push apart the particles of packings to be made")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  command.add_option("--repeats", options.effort.repeats, "Runs of each contestant after the first, which warms up")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command.add_option("--seconds", options.effort.seconds, "A contestant that has taken that long is not run again")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--patience", options.effort.patience, "Seconds after which a single run is given up")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--memory", options.effort.memory, "GiB that a contestant may ask for (any)")
      ->check(CLI::PositiveNumber);
  command.add_option("--only", options.only, "Contestants to measure, as patterns of NAME/VARIANT/ISA/THREADS (all)")
      ->take_all();
  command.add_option("--skip", options.skip, "Contestants to leave out, as patterns");
  command.add_option("--threads", options.threads, "Measure only contestants of these numbers of threads")
      ->delimiter(',');
  command.add_option("--csv", options.csv, "Also write the results to this file");
  command.add_flag("--list", options.list, "Only list the contestants");
}

}  // namespace

int main(int argc, char **argv) {
  return bench::run_program("hgrid_compare", "Time contact searches side by side and compare their pairs", argc, argv,
                            add_options, compare);
}
