// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/hgrid/commands/bench_steps.hpp"

#include "particles/text/output.hpp"
#include "programs/measure/step_timer.hpp"

#include <cstdio>
#include <vector>

namespace command {
namespace {

// One skin.
struct Run {
  double skin;
  measure::MovingGrid grid;
  measure::StepTimes times;
};

// Times are ns per particle; 0 where no step was of that kind.
struct SkinRow {
  double skin = 0, mean = 0, searched = 0, filtered = 0, search_share = 0, candidates = 0;
  size_t pairs = 0;
};

SkinRow row_of(Run &run, size_t count) {
  const double ns = 1e9 / static_cast<double>(count);
  const double stored = static_cast<double>(run.grid.grid().get_stats().stored_count) / static_cast<double>(count);
  return {
      run.skin, run.times.mean() * ns,  run.times.searched() * ns, run.times.filtered() * ns, run.times.search_share(),
      stored,   run.grid.pairs().size()};
}

void write_csv(const std::string &path, const StepOptions &options, const std::vector<SkinRow> &rows) {
  particles::Output out(path);
  out << "skin,displacement,steps,ns_per_particle_and_step,search_share,ns_searched,ns_filtered,"
         "stored_per_particle,pairs\n";
  for (const SkinRow &row : rows) {
    out << row.skin << ',' << options.displacement << ',' << options.steps << ',' << row.mean << ',' << row.search_share
        << ',' << row.searched << ',' << row.filtered << ',' << row.candidates << ',' << row.pairs << '\n';
  }
  out.close();
}

}  // namespace

void bench_steps(const StepOptions &options, hg_grid_def def, const particles::ParticleSet &particles,
                 const std::string &name, const std::string &csv) {
  measure::Flight flight(particles, options.displacement);
  std::vector<Run> runs;
  for (const double skin : options.skins) {
    def.skin = skin;
    runs.push_back({skin, measure::MovingGrid(def, particles), {}});
  }
  // All skins take turns at each step, so that a slow moment of the machine touches all alike.
  for (int step = 0; step < options.steps; step++) {
    flight.step();
    for (Run &run : runs) measure::time_step(run.grid, flight.particles(), run.times);
  }
  std::printf("%s: %zu particles, %d steps of up to %g; hg_move and hg_query_pairs, ns per particle and step\n\n",
              name.c_str(), particles.count(), options.steps, options.displacement);
  std::printf("%10s %10s %12s %12s %12s %12s %10s\n", "skin", "mean", "searched", "if searched", "if filtered",
              "stored", "pairs");
  std::vector<SkinRow> rows;
  for (Run &run : runs) {
    rows.push_back(row_of(run, particles.count()));
    const SkinRow &row = rows.back();
    std::printf("%10g %10.1f %11.0f%% %12.1f %12.1f %12.2f %10zu\n", row.skin, row.mean, 100 * row.search_share,
                row.searched, row.filtered, row.candidates, row.pairs);
  }
  if (!csv.empty()) write_csv(csv, options, rows);
}

}  // namespace command
