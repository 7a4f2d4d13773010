// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// `hgrid run`: simulates a scene.
#include "dem/effects/table.hpp"
#include "dem/engine/engine.hpp"
#include "dem/engine/watch.hpp"
#include "dem/output/earlier_run.hpp"
#include "dem/output/recorder.hpp"
#include "dem/scene/scene.hpp"
#include "particles/error.hpp"
#include "particles/text/formatted.hpp"
#include "particles/text/lists.hpp"
#include "programs/accuracy/report/tables.hpp"
#include "programs/hgrid/command.hpp"
#include "programs/hgrid/interrupt.hpp"
#include "programs/hgrid/run_line.hpp"
#include "programs/hgrid/sweep.hpp"
#include "programs/measure/timing.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace command {
namespace {

using Clock = std::chrono::steady_clock;

struct RunOptions {
  std::string scene;
  std::string restart;
  std::string from;
  std::string directory;
  std::optional<int> threads;
  std::optional<double> skin;
  std::optional<uint64_t> steps;
  std::vector<std::string> settings;
  bool quiet = false;
  bool strict = false;
  bool overwrite = false;
};

// One run of an engine with what is recorded on the way.
class Run {
 public:
  Run(const scene::Scene &scene, dem::Engine &engine, output::Recorder &recorder, const Interrupt &interrupt,
      const RunOptions &options)
      : scene_(scene),
        engine_(engine),
        recorder_(recorder),
        interrupt_(interrupt),
        options_(options),
        watch_(scene.setup),
        first_(engine.steps_done()),
        line_(engine.steps_done(), scene.steps) {}

  // To the end, or to the first interrupt: then the checkpoint holds the state.
  void go() {
    record();
    while (engine_.steps_done() < scene_.steps && !interrupt_.requested()) {
      const uint64_t step = engine_.steps_done();
      const uint64_t until = next_record(scene_.output, step, std::min(scene_.steps, step + line_.patience()));
      const Clock::time_point start = Clock::now();
      engine_.run(until - step);
      line_.worked(until - step, engine_.particle_count(), measure::seconds_since(start));
      record();
    }
    line_.wipe();
    if (interrupt_.requested()) save();
  }

  const RunLine &line() const { return line_; }
  const dem::Watch &watch() const { return watch_; }

 private:
  bool is_time(uint64_t interval) const { return is_recorded(interval, engine_.steps_done(), scene_.steps); }

  void record() {
    const uint64_t step = engine_.steps_done();
    // Goes on from a checkpoint or another stage: what was due there is written.
    const bool again = step == first_ && step > 0;
    const bool row = is_time(scene_.output.energies) && !again, shows = !options_.quiet && line_.is_due();
    if (row || shows || again) {
      // Measuring does a part of the next step's work, so it counts as work.
      const Clock::time_point start = Clock::now();
      const dem::Measurement m = engine_.measure();
      line_.worked(0, 0, measure::seconds_since(start));
      if (!std::isfinite(m.energy()))
        throw particles::Error("the energy is not finite at step " + std::to_string(step));
      if (row) record_tables(step, m);
      look(step, m);
      if (shows) line_.show(step, m);
    }
    if (again) return;
    if (is_time(scene_.output.pictures)) recorder_.picture(scene_.setup, step, engine_);
    if (is_time(scene_.output.checkpoints)) save();
  }

  void record_tables(uint64_t step, const dem::Measurement &m) {
    recorder_.measurement(step, m);
    recorder_.walls(step, m.time, engine_.walls_now());
    recorder_.regions(step, scene_.output.regions, engine_);
    recorder_.passages(step, m.time, engine_.passages());
  }

  void save() {
    dem::Checkpoint checkpoint;
    scene::save(scene_, engine_, checkpoint);
    checkpoint.write(recorder_.checkpoint_path());
  }

  void look(uint64_t step, const dem::Measurement &m) {
    for (const std::string &warning : watch_.look(step, m)) {
      line_.wipe();
      const std::string text = "step " + std::to_string(step) + ": " + warning;
      if (options_.strict) throw particles::Error(text);
      std::fprintf(stderr, "hgrid: warning: %s\n", text.c_str());
    }
  }

  const scene::Scene &scene_;
  dem::Engine &engine_;
  output::Recorder &recorder_;
  const Interrupt &interrupt_;
  const RunOptions &options_;
  dem::Watch watch_;
  uint64_t first_;
  RunLine line_;
};

void print_passages(const std::vector<dem::Passage> &passages) {
  for (const dem::Passage &passage : passages) {
    const std::string waiting =
        passage.waiting > 0 ? ", " + std::to_string(passage.waiting) + " wait for room" : std::string();
    std::printf("%s: %llu particles of mass %.6g%s\n", passage.name.c_str(),
                static_cast<unsigned long long>(passage.count), passage.mass, waiting.c_str());
  }
}

void print_summary(dem::Engine &engine, const Run &run) {
  const RunLine &line = run.line();
  const dem::Measurement m = engine.measure();
  const hg_grid_stats stats = engine.grid_stats();
  const double count = std::max(1.0, static_cast<double>(engine.particle_count()));
  std::printf("%llu steps to time %.6g in %.3g s of work: %.1f ns per particle and step\n",
              static_cast<unsigned long long>(engine.steps_done()), m.time, line.seconds(),
              line.ns_per_particle_step());
  std::printf("energy %.12g: translation %.6g, rotation %.6g, contacts %.6g, gravity %.6g\n", m.energy(), m.translation,
              m.rotation, m.contact, m.gravity);
  std::printf("%zu contacts of particles, %zu with walls, largest overlap %.3g of the smaller radius\n", m.contacts,
              m.wall_contacts, m.largest_overlap);
  std::printf("%s: %s\n", run.watch().has_warned() ? "worst seen, see the warnings" : "worst seen, nothing to warn of",
              run.watch().summary().c_str());
  print_passages(engine.passages());
  std::printf("memory per particle: %.0f bytes of state, %.0f of the grid; %lld levels, %lld searches\n",
              static_cast<double>(engine.state_bytes()) / count, static_cast<double>(stats.byte_count) / count,
              static_cast<long long>(stats.level_count), static_cast<long long>(stats.search_count));
}

// What the table of a sweep tells of a run.
struct Outcome {
  dem::Measurement end;
  double ns_per_particle_step = 0;
  bool has_warned = false;
};

// A stage as the command line wants it; `folder`: inside that of the output, "" for that itself.
scene::Scene with_options(scene::Scene scene, const RunOptions &options, bool is_last, const std::string &folder) {
  if (options.threads) scene.setup.threads = *options.threads;
  if (options.skin) scene.setup.skin = *options.skin;
  if (options.steps) scene.steps = is_last ? *options.steps : std::min(scene.steps, *options.steps);
  if (!options.directory.empty()) scene.output.directory = options.directory;
  if (!folder.empty()) scene.output.directory += "/" + folder;
  return scene;
}

std::unique_ptr<dem::Engine> engine_of(const scene::Scene &scene) {
  std::unique_ptr<dem::Engine> engine = dem::make_engine(scene.setup, scene.precision);
  if (scene.output.work) engine->count_work();
  return engine;
}

void restore(dem::Engine &engine, const dem::Checkpoint &checkpoint) {
  try {
    engine.restore(checkpoint);
  } catch (const particles::Error &error) {
    throw particles::Error(std::string(error.what()) + "; --from begins another scene from it");
  }
}

Outcome run_scene(const RunOptions &options, const Settings &settings, const std::string &folder) {
  if (!options.restart.empty() && !options.from.empty())
    throw CLI::ValidationError("--from", "begins a run, and --restart goes on with one");
  std::optional<dem::Checkpoint> checkpoint;
  if (!options.restart.empty()) checkpoint = dem::Checkpoint::read(options.restart);
  std::optional<scene::Departure> departure;
  if (checkpoint) departure = scene::start_in(*checkpoint);
  if (!options.from.empty()) departure = scene::end_in(dem::Checkpoint::read(options.from));
  const scene::StagedScene stages(options.scene, settings, std::move(departure));
  const auto prepared = [&](scene::Scene scene) {
    const bool is_last = scene.stage + 1 == stages.count();
    return with_options(std::move(scene), options, is_last, folder);
  };
  scene::Scene scene = prepared(checkpoint ? scene::stage_of(stages, *checkpoint) : stages.first());
  std::unique_ptr<dem::Engine> engine = engine_of(scene);
  if (checkpoint) restore(*engine, *checkpoint);
  if (!checkpoint) output::require_no_earlier_run(scene.output.directory, options.overwrite);
  if (!scene.unused.empty())
    std::fprintf(stderr, "hgrid: %s: note: of its particle files these columns are not used: %s\n",
                 options.scene.c_str(), particles::joined(scene.unused).c_str());
  const scene::OutputPlan plan = scene.output;
  output::Recorder recorder(plan.directory, {plan.formats, plan.work, plan.bulk, plan.contacts}, engine->steps_done());
  const Interrupt interrupt;
  for (;;) {
    print_scene(scene, options.scene);
    std::fflush(stdout);
    Run run(scene, *engine, recorder, interrupt, options);
    run.go();
    print_summary(*engine, run);
    if (interrupt.requested()) {
      throw particles::Error("interrupted at step " + std::to_string(engine->steps_done()) + "; go on with hgrid run " +
                             options.scene + " --restart " + recorder.checkpoint_path());
    }
    const bool stops_here = options.steps && engine->steps_done() >= *options.steps;
    if (scene.stage + 1 == stages.count() || stops_here) {
      return {engine->measure(), run.line().ns_per_particle_step(), run.watch().has_warned()};
    }
    scene = prepared(stages.after(scene, engine->hand_over()));
    engine = engine_of(scene);
  }
}

using Table = std::vector<std::vector<std::string>>;

std::vector<std::string> row_of(const Settings &settings, const Outcome &run) {
  std::vector<std::string> row;
  for (const scene::Setting &setting : settings) row.push_back(setting.value);
  const dem::Measurement &m = run.end;
  for (const double value : {m.time, m.energy(), m.translation + m.rotation})
    row.push_back(particles::formatted("%.6g", value));
  row.push_back(std::to_string(m.contacts + m.wall_contacts));
  row.push_back(particles::formatted("%.3g", m.largest_overlap));
  row.push_back(particles::formatted("%.1f", run.ns_per_particle_step));
  row.emplace_back(run.has_warned ? "yes" : "no");
  return row;
}

// One folder for each combination, and a table of their ends.
void run_sweep(const RunOptions &options, const std::vector<Settings> &all) {
  if (!options.restart.empty()) throw CLI::ValidationError("--restart", "goes on with one run, not with a sweep");
  Table table(1);
  for (const scene::Setting &setting : all.front()) table[0].push_back(setting.path);
  for (const char *head : {"time", "energy", "kinetic", "contacts", "overlap", "ns", "warned"})
    table[0].emplace_back(head);
  for (const Settings &settings : all) {
    const std::string name = name_of(settings);
    std::printf("%s%s\n", table.size() > 1 ? "\n" : "", name.c_str());
    table.push_back(row_of(settings, run_scene(options, settings, name)));
  }
  std::printf("\nThe ends; overlap: the largest over the smaller radius, ns: per particle and step\n\n%s",
              accuracy::table_of(table, accuracy::Style::kText).c_str());
}

void run_command(const RunOptions &options) {
  const std::vector<Settings> all = combinations(options.settings);
  if (all.size() == 1) {
    run_scene(options, all.front(), "");
  } else {
    run_sweep(options, all);
  }
}

}  // namespace

void add_run(CLI::App &parent) {
  auto options = std::make_shared<RunOptions>();
  CLI::App *command =
      parent.add_subcommand("run", "Simulate a scene (docs/guide/simulation.md tells how to write one)");
  command->add_option("SCENE", options->scene, "The scene, a TOML file")->required();
  command->add_option("--restart", options->restart, "Go on from this checkpoint, to the same bits");
  command->add_option("--from", options->from,
                      "Begin with the particles, their motion and contacts of this checkpoint of any scene, instead of "
                      "[[particles]]");
  command->add_option("--output", options->directory, "Folder for what is written, instead of the scene's");
  command->add_option("--threads", options->threads, "Instead of the scene's; 0: all that the machine offers")
      ->check(CLI::Range(0, 1024));
  command->add_option("--skin", options->skin, "Instead of the scene's")->check(CLI::NonNegativeNumber);
  command->add_option("--steps", options->steps, "Last step, instead of the scene's end");
  command->add_flag("--quiet", options->quiet, "No line about the progress");
  command->add_flag("--strict", options->strict, "What a run is warned of ends it");
  command->add_option("--set", options->settings,
                      "TABLE.KEY=VALUE[,VALUE...] instead of the scene's; more than one value: a run for each, in a "
                      "folder of its name, and a table of their ends");
  command->add_flag("--overwrite", options->overwrite, "Remove the earlier run that the folder holds");
  command->callback([options] { run_command(*options); });
}

}  // namespace command
