// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_rank_scene: times a scene over ranks of MPI, and on one rank the engine of hgrid run beside it. A CSV row.
#include "dem/scene/scene.hpp"
#include "dem_mpi/rank_engine.hpp"
#include "programs/bench/mpi_clock.hpp"
#include "programs/bench/program.hpp"
#include "programs/measure/timing.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <string>

namespace {

struct Options {
  std::string scene;
  uint64_t warm = 50, steps = 100, balance = 1000;
};

struct StepTime {
  double wall, work, processor;  // ms
};

// Of each step, once some are done.
template <class Engine>
StepTime time_of(Engine &engine, const Options &options) {
  engine.run(options.warm);
  const bench::RankTime start = bench::rank_time();
  const double wall = measure::seconds_of([&] { engine.run(options.steps); });
  const bench::RankTime end = bench::rank_time();
  const double per = 1e3 / static_cast<double>(options.steps);
  return {wall * per, (end.work() - start.work()) * per, (end.processor - start.processor) * per};
}

double sum_of(double mine) {
  double sum = 0;
  MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return sum;
}

int measure_scene(const Options &options) {
  const dem::ranks::Ranks ranks(MPI_COMM_WORLD);
  const scene::Scene scene = scene::read_scene(options.scene);
  const auto engine = dem::ranks::make_rank_engine({scene.setup, ranks, options.balance});
  const StepTime mine = time_of(*engine, options);
  const hg_mpi_stats stats = engine->stats();
  const double most = ranks.largest(mine.work), wall = ranks.largest(mine.wall), all = sum_of(mine.work);
  const double processor = sum_of(mine.processor), ghosts = sum_of(static_cast<double>(stats.ghost_count));
  if (!ranks.is_first()) return 0;
  std::printf(
      "engine,ranks,particles,ghosts,lists,ms per step,work of the busiest rank,of all,processor time of all\n");
  std::printf("over ranks,%d,%zu,%.0f,%lld,%.2f,%.2f,%.2f,%.2f\n", ranks.size(), scene.setup.count(), ghosts,
              static_cast<long long>(stats.selection_count), wall, most, all, processor);
  if (ranks.size() > 1) return 0;
  const auto alone = dem::make_engine(scene.setup);
  const StepTime plain = time_of(*alone, options);
  std::printf("of hgrid run,1,%zu,0,%lld,%.2f,%.2f,%.2f,%.2f\n", scene.setup.count(),
              static_cast<long long>(alone->grid_stats().search_count), plain.wall, plain.work, plain.work,
              plain.processor);
  return 0;
}

void add_options(CLI::App &command, Options &options) {
  command.add_option("SCENE", options.scene, "The scene, a TOML file")->required();
  command.add_option("--warm", options.warm, "Steps before those that are timed")->capture_default_str();
  command.add_option("--steps", options.steps, "Steps that are timed")->capture_default_str();
  command.add_option("--balance", options.balance, "Steps between choices of new owners")->capture_default_str();
}

}  // namespace

int main(int argc, char **argv) {
  MPI_Init(&argc, &argv);
  const int code =
      bench::run_program("hgrid_rank_scene", "Time a scene over ranks of MPI", argc, argv, add_options, measure_scene);
  // A rank that failed does not let others wait.
  if (code != 0) MPI_Abort(MPI_COMM_WORLD, code);
  MPI_Finalize();
  return code;
}
