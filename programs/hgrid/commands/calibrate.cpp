// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// `hgrid calibrate`: fits the prices by which levels are chosen to the times measured on this machine.
#include "particles/error.hpp"
#include "particles/files/reader.hpp"
#include "programs/accuracy/search/systems.hpp"
#include "programs/hgrid/command.hpp"
#include "programs/measure/least_squares.hpp"
#include "programs/measure/search_timer.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace command {
namespace {

struct CalibrateOptions {
  std::vector<std::string> files;
  size_t count = 50000;
  int repeats = 7;
  int most_levels = 8;
  int threads = 1;
  double seconds = 1;
};

struct System {
  std::string name;
  particles::ParticleSet particles;
};

enum Term { kLevels, kRows, kTests, kTerms };
using Observation = measure::Observation<kTerms>;

// A number of levels of a system, what the library expects of it, and its time.
struct Sample {
  const System *system;
  int levels;
  Observation observation;
  measure::SearchTimer timer;

  void run() { timer.run(); }
};

// Levels that take this much longer than the best are never chosen; they would bend the fit where it matters.
constexpr double kDearest = 2.5;

std::vector<System> make_systems(const CalibrateOptions &options) {
  std::vector<System> systems;
  for (const std::string &file : options.files) systems.push_back({file, particles::read_particles(file)});
  if (!systems.empty()) return systems;
  using packing::Law;
  const std::vector<accuracy::NamedLaw> laws = {{"mono", {Law::kMono, 1, 3}},
                                                {"two-sizes, ratio 5", {Law::kTwoSizes, 5, 3}},
                                                {"uniform-size, ratio 50", {Law::kUniformSize, 50, 3}},
                                                {"uniform-volume, ratio 10", {Law::kUniformVolume, 10, 3}},
                                                {"uniform-volume, ratio 30", {Law::kUniformVolume, 30, 3}},
                                                {"log-normal, sigma 0.3", {Law::kLogNormal, 1, 3, 3, 0.3}},
                                                {"log-normal, sigma 1", {Law::kLogNormal, 1, 3, 3, 1}},
                                                {"power-law, ratio 20, exponent 4", {Law::kPowerLaw, 20, 3, 4}}};
  for (const auto &[name, law] : laws) {
    systems.push_back({name, accuracy::relaxed(law, options.count, 20)});
  }
  return systems;
}

hg_grid_def grid_def(const CalibrateOptions &options, const particles::ParticleSet &particles, int level_count) {
  hg_grid_def def = measure::def_of(particles);
  def.level_count = level_count;
  def.thread_count = options.threads;
  def.level_price = def.row_price = 0;
  return def;
}

// The cost that the library expects of `levels` levels at these prices; negative if it cannot make as many.
double expected_cost(hg_grid_def def, const particles::ParticleSet &particles, int levels) {
  hgrid::Grid grid(def);
  particles::insert(particles, grid);
  const std::optional<hg_level_cost> cost = measure::expected_cost(grid, static_cast<size_t>(levels));
  return cost ? cost->cost : -1;
}

// With one price 1 and all others 0 the cost is the count itself, and the tests, whose price is always 1.
std::vector<Sample> make_samples(const CalibrateOptions &options, const std::vector<System> &systems) {
  std::vector<Sample> samples;
  for (const System &system : systems) {
    const auto group = static_cast<size_t>(&system - systems.data());
    for (int levels = 1; levels <= options.most_levels; levels++) {
      hg_grid_def def = grid_def(options, system.particles, levels);
      const double tests = expected_cost(def, system.particles, levels);
      if (tests < 0) continue;
      Sample sample{&system, levels, {}, measure::SearchTimer(def, system.particles)};
      std::array<double, kTerms> &term = sample.observation.term;
      sample.observation.group = group;
      term[kLevels] = levels;
      def.row_price = 1;
      term[kRows] = expected_cost(def, system.particles, levels) - tests;
      term[kTests] = tests;
      samples.push_back(std::move(sample));
    }
  }
  return samples;
}

void measure_samples(const CalibrateOptions &options, std::vector<Sample> &samples) {
  measure::in_turns(samples, options.repeats, options.seconds);
  for (Sample &sample : samples) {
    sample.observation.value = sample.timer.ns_per_particle();
    sample.observation.weight = 1 / (sample.observation.value * sample.observation.value);
  }
}

double best_time(const std::vector<Sample> &samples, const System *system) {
  double best = HUGE_VAL;
  for (const Sample &s : samples) {
    if (s.system == system) best = std::min(best, s.observation.value);
  }
  return best;
}

void drop_dear_ones(std::vector<Sample> &samples) {
  std::vector<Sample> kept;
  for (Sample &s : samples) {
    if (s.observation.value <= kDearest * best_time(samples, s.system)) kept.push_back(std::move(s));
  }
  samples.swap(kept);
}

std::vector<Observation> observations_of(const std::vector<Sample> &samples) {
  std::vector<Observation> observations;
  std::transform(samples.begin(), samples.end(), std::back_inserter(observations),
                 [](const Sample &sample) { return sample.observation; });
  return observations;
}

// What the prices are for: the times of a system's numbers of levels relative to each other. Its constant is the rest.
void print_samples(const std::vector<Sample> &samples, const std::array<double, kTerms> &ns) {
  const std::vector<Observation> observations = observations_of(samples);
  const std::vector<Observation> centered = measure::centered(observations);
  std::printf("%-34s %6s %8s %8s %10s %10s %8s\n", "system", "levels", "rows", "tests", "ns/part.", "fit", "error");
  double squares = 0;
  for (size_t i = 0; i < samples.size(); i++) {
    const Observation &o = observations[i];
    const double fit = o.value - centered[i].value + measure::sum_of(ns, centered[i].term), error = fit / o.value - 1;
    squares += error * error;
    std::printf("%-34s %6d %8.2f %8.1f %10.1f %10.1f %7.1f%%\n", samples[i].system->name.c_str(), samples[i].levels,
                o.term[kRows], o.term[kTests], o.value, fit, 100 * error);
  }
  std::printf("root mean square error %.1f %%\n\n", 100 * std::sqrt(squares / static_cast<double>(samples.size())));
}

void print_choices(const std::vector<System> &systems, const std::vector<Sample> &samples,
                   const std::array<double, kTerms> &ns) {
  std::printf("%-34s %10s %10s %18s\n", "system", "best L", "chosen L", "chosen over best");
  for (const System &system : systems) {
    std::vector<const Sample *> own;
    for (const Sample &s : samples) {
      if (s.system == &system) own.push_back(&s);
    }
    if (own.empty()) continue;
    const auto least = [&own](const auto &cost_of) {
      return *std::min_element(own.begin(), own.end(),
                               [&](const Sample *a, const Sample *b) { return cost_of(*a) < cost_of(*b); });
    };
    const Sample *best = least([](const Sample &s) { return s.observation.value; });
    const Sample *chosen = least([&ns](const Sample &s) { return measure::sum_of(ns, s.observation.term); });
    std::printf("%-34s %10d %10d %18.3f\n", system.name.c_str(), best->levels, chosen->levels,
                chosen->observation.value / best->observation.value);
  }
}

void run_calibrate(const CalibrateOptions &options) {
  const std::vector<System> systems = make_systems(options);
  for (const System &system : systems) {
    if (system.particles.count() == 0) throw particles::Error(system.name, 0, "no particles to time");
  }
  std::vector<Sample> samples = make_samples(options, systems);
  measure_samples(options, samples);
  drop_dear_ones(samples);
  const std::vector<Observation> observations = observations_of(samples);
  const std::array<double, kTerms> ns = measure::fit_non_negative(observations);
  const char *isa = std::getenv("HGRID_ISA");
  std::printf("instruction set: %s; counts and times per particle\n\n",
              isa != nullptr ? isa : "the best of this machine");
  print_samples(samples, ns);
  print_choices(systems, samples, ns);
  std::printf("\nns for: level %.2f, row %.2f, test %.3f\n", ns[kLevels], ns[kRows], ns[kTests]);
  if (!(ns[kTests] > 0)) throw particles::Error("the tests took no measurable time: no prices in units of a test");
  std::printf("prices, in hg_grid_def: level_price = %.3g, row_price = %.3g\n", ns[kLevels] / ns[kTests],
              ns[kRows] / ns[kTests]);
}

}  // namespace

void add_calibrate(CLI::App &parent) {
  auto options = std::make_shared<CalibrateOptions>();
  CLI::App *command = parent.add_subcommand("calibrate", "Fit the prices that choose the levels to this machine");
  command->add_option("FILE", options->files, "Particle files to fit to, instead of packings of the command's own");
  command->add_option("--count", options->count, "Particles of each packing of the command's own")
      ->check(CLI::Range(1000, 100000000))
      ->capture_default_str();
  command->add_option("--repeats", options->repeats, "Runs of each number of levels; the median counts")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command->add_option("--most-levels", options->most_levels, "Largest number of levels to try")
      ->check(CLI::Range(2, static_cast<int>(HG_MAX_LEVELS)))
      ->capture_default_str();
  command->add_option("--seconds", options->seconds, "A number of levels that has taken that long is not run again")
      ->capture_default_str();
  command->add_option("--threads", options->threads, "Threads of the search, 0 = all")->capture_default_str();
  command->footer(
      "The library ships one set of prices for all instruction sets, as the order of the pairs must not depend on the\n"
      "machine. Set those printed here in hg_grid_def if they choose better on yours.\n"
      "Examples:\n"
      "  hgrid calibrate\n"
      "  HGRID_ISA=sse2 hgrid calibrate packing.csv other.csv");
  command->callback([options] { run_calibrate(*options); });
}

}  // namespace command
