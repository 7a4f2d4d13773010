// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid-mpi run: simulates a scene over ranks, to the same bits on any number of them.
#include "dem/engine/watch.hpp"
#include "dem/output/earlier_run.hpp"
#include "dem_mpi/rank_engine.hpp"
#include "dem_mpi/rank_files.hpp"
#include "particles/error.hpp"
#include "particles/text/lists.hpp"
#include "programs/hgrid/interrupt.hpp"
#include "programs/hgrid/run_line.hpp"
#include "programs/hgrid/sweep.hpp"
#include "programs/hgrid_mpi/command.hpp"
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

struct RankRunOptions {
  std::string scene, restart, directory;
  std::optional<double> skin;
  std::optional<uint64_t> steps;
  std::vector<std::string> settings;
  uint64_t balance = 1000;
  bool quiet = false, strict = false, overwrite = false;
};

// What scenes may ask for and ranks do not do yet, with its key.
void refuse_unknown(const scene::StagedScene &stages, const scene::Scene &scene, const std::string &path) {
  const auto refuse = [&](const std::string &what) { throw particles::Error(path + ": " + what); };
  const std::string not_yet = " is not done over ranks yet: hgrid run does it";
  if (stages.count() > 1 || !scene.stage_name.empty()) refuse("[[stage]]" + not_yet);
  if (scene.precision != dem::Precision::kDouble) refuse("precision = \"float\" of [run]" + not_yet);
  for (const auto &[asked, key] : {std::pair{scene.output.work, "work"}, std::pair{scene.output.bulk, "bulk"},
                                   std::pair{scene.output.contacts, "contacts"}}) {
    if (asked) refuse(std::string("the key ") + key + " of [output]" + not_yet);
  }
  if (scene.output.formats != std::vector<std::string>{"vtp"})
    refuse("formats = " + particles::joined(scene.output.formats) +
           " of [output]: over ranks pictures are vtp alone, with an index .pvtp");
  if (!scene.output.regions.empty()) refuse("[[region]]" + not_yet);
  const std::string fault = dem::ranks::fault_over_ranks(scene.setup);
  if (!fault.empty()) refuse(fault);
}

scene::Scene read_for_ranks(const RankRunOptions &options, const Settings &settings) {
  const scene::StagedScene stages(options.scene, settings);
  scene::Scene scene = stages.first();
  refuse_unknown(stages, scene, options.scene);
  if (options.skin) scene.setup.skin = *options.skin;
  if (options.steps) scene.steps = *options.steps;
  if (!options.directory.empty()) scene.output.directory = options.directory;
  return scene;
}

// One run with what is recorded on the way. All ranks decide alike: by the step, or as the first one does.
class RankRun {
 public:
  RankRun(const dem::ranks::Ranks &ranks, const scene::Scene &scene, size_t particles, dem::Watch &watch,
          dem::ranks::RankEngine &engine, dem::ranks::RankFiles &files, const RankRunOptions &options)
      : ranks_(ranks),
        scene_(scene),
        watch_(watch),
        engine_(engine),
        files_(files),
        options_(options),
        first_(engine.steps_done()),
        particles_(particles),
        line_(engine.steps_done(), scene.steps) {}

  // To the end, or to the first interrupt: then the checkpoint holds the state.
  void go() {
    record();
    while (engine_.steps_done() < scene_.steps) {
      if (ranks_.any(interrupt_.requested())) return stop();
      const uint64_t step = engine_.steps_done();
      const uint64_t most = ranks_.of_first(std::min(scene_.steps, step + line_.patience()));
      const uint64_t until = next_record(scene_.output, step, most);
      const auto start = std::chrono::steady_clock::now();
      engine_.run(until - step);
      line_.worked(until - step, particles_, measure::seconds_since(start));
      record();
    }
    line_.wipe();
  }

  const RunLine &line() const { return line_; }

 private:
  void stop() {
    line_.wipe();
    files_.save(engine_);
    throw particles::Error("interrupted at step " + std::to_string(engine_.steps_done()) +
                           "; go on with hgrid-mpi run " + options_.scene + " --restart " + files_.checkpoint_path());
  }

  bool is_time(uint64_t interval) const { return is_recorded(interval, engine_.steps_done(), scene_.steps); }

  void record() {
    const uint64_t step = engine_.steps_done();
    const bool again = step == first_ && step > 0;  // what was due there is written
    const bool row = is_time(scene_.output.energies) && !again;
    const bool shows = ranks_.of_first(!options_.quiet && line_.is_due());
    if (row || shows || again) {
      const auto start = std::chrono::steady_clock::now();
      const dem::Measurement m = engine_.measure();
      line_.worked(0, 0, measure::seconds_since(start));
      if (!std::isfinite(m.energy()))
        throw particles::Error("the energy is not finite at step " + std::to_string(step));
      if (row) files_.measurement(step, m);
      look(step, m);
      if (shows && ranks_.is_first()) line_.show(step, m);
    }
    if (again) return;
    if (is_time(scene_.output.pictures)) files_.picture(scene_.setup, step, engine_);
    if (is_time(scene_.output.checkpoints)) files_.save(engine_);
  }

  void look(uint64_t step, const dem::Measurement &m) {
    for (const std::string &warning : watch_.look(step, m)) {
      line_.wipe();
      const std::string text = "step " + std::to_string(step) + ": " + warning;
      if (options_.strict) throw particles::Error(text);
      if (ranks_.is_first()) std::fprintf(stderr, "hgrid-mpi: warning: %s\n", text.c_str());
    }
  }

  const dem::ranks::Ranks &ranks_;
  const scene::Scene &scene_;
  dem::Watch &watch_;
  dem::ranks::RankEngine &engine_;
  dem::ranks::RankFiles &files_;
  const RankRunOptions &options_;
  const Interrupt interrupt_;
  uint64_t first_;
  size_t particles_;
  RunLine line_;
};

void print_summary(const dem::ranks::Ranks &ranks, const RunLine &line, dem::ranks::RankEngine &engine,
                   size_t particles) {
  const dem::Measurement m = engine.measure();
  const hg_mpi_stats stats = engine.stats();
  std::vector<int64_t> sums = {stats.ghost_count, stats.sent_byte_count};
  ranks.add_up(sums);
  const int64_t most = ranks.largest(stats.owned_count), least = -ranks.largest(-stats.owned_count);
  if (!ranks.is_first()) return;
  std::printf("%llu steps to time %.6g in %.3g s of work: %.1f ns per particle and step\n",
              static_cast<unsigned long long>(engine.steps_done()), m.time, line.seconds(),
              line.ns_per_particle_step());
  std::printf("energy %.12g: translation %.6g, rotation %.6g, contacts %.6g, gravity %.6g\n", m.energy(), m.translation,
              m.rotation, m.contact, m.gravity);
  std::printf("%zu contacts of particles, %zu with walls, largest overlap %.3g of the smaller radius\n", m.contacts,
              m.wall_contacts, m.largest_overlap);
  std::printf("%d ranks with %lld to %lld particles, %.3f ghosts per particle; lists made %lld times, %.3g MB sent\n",
              ranks.size(), static_cast<long long>(least), static_cast<long long>(most),
              static_cast<double>(sums[0]) / static_cast<double>(particles),
              static_cast<long long>(stats.selection_count), 1e-6 * static_cast<double>(sums[1]));
  if (!engine.balance_fault().empty())
    std::printf("particles stayed with their ranks: %s\n", engine.balance_fault().c_str());
}

void run(const RankRunOptions &options) {
  const std::vector<Settings> settings = combinations(options.settings);
  if (settings.size() > 1) throw CLI::ValidationError("--set", "takes one value over ranks: hgrid run does sweeps");
  const dem::ranks::Ranks ranks(MPI_COMM_WORLD);
  std::optional<scene::Scene> read;
  ranks.together([&] { read = read_for_ranks(options, settings.front()); });
  scene::Scene &scene = *read;
  const size_t particles = scene.setup.count();
  dem::ranks::PartsIndex done;
  std::unique_ptr<dem::ranks::RankEngine> engine;
  const dem::ranks::RankPlan plan{scene.setup, ranks, options.balance};
  if (options.restart.empty()) {
    ranks.together([&] {
      if (ranks.is_first()) output::require_no_earlier_run(scene.output.directory, options.overwrite);
    });
    engine = dem::ranks::make_rank_engine(plan);
  } else {
    done = dem::ranks::read_index(ranks, options.restart);
    engine = dem::ranks::make_rank_engine(plan, dem::ranks::read_parts(ranks, options.restart, done));
  }
  if (ranks.is_first()) {
    print_scene(scene, options.scene);
    std::fflush(stdout);
  }
  dem::Watch watch(scene.setup);
  // From here on each rank has its own particles alone.
  static_cast<dem::ParticleArrays &>(scene.setup) = {};
  dem::ranks::RankFiles files(ranks, scene.output.directory, done);
  RankRun this_run(ranks, scene, particles, watch, *engine, files, options);
  this_run.go();
  print_summary(ranks, this_run.line(), *engine, particles);
}

}  // namespace

void add_rank_run(CLI::App &parent) {
  auto options = std::make_shared<RankRunOptions>();
  CLI::App &command = *parent.add_subcommand("run", "Simulate a scene, under mpirun");
  command.add_option("SCENE", options->scene, "The scene, a TOML file, which each rank reads")->required();
  command.add_option("--restart", options->restart, "Go on from this checkpoint, on any number of ranks");
  command.add_option("--output", options->directory, "Folder for what is written, instead of the scene's");
  command.add_option("--skin", options->skin, "Instead of the scene's")->check(CLI::NonNegativeNumber);
  command.add_option("--steps", options->steps, "Last step, instead of the scene's end");
  command
      .add_option("--balance", options->balance, "Steps after which particles get new owners; 0: they keep their ranks")
      ->capture_default_str();
  command.add_flag("--quiet", options->quiet, "No line about the progress");
  command.add_flag("--strict", options->strict, "What a run is warned of ends it");
  command.add_option("--set", options->settings, "TABLE.KEY=VALUE instead of the scene's");
  command.add_flag("--overwrite", options->overwrite, "Remove the earlier run that the folder holds");
  command.footer(
      "States, energies and checkpoints have the same bits on any number of ranks. States are state-STEP.pvtp with a\n"
      "piece for each rank; a checkpoint is the file `checkpoint` with a part for each rank beside it.\n"
      "Example:\n"
      "  mpirun -n 4 hgrid-mpi run scenes/cooling-gas.toml");
  command.callback([options] { run(*options); });
}

}  // namespace command
