// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/hgrid/commands/bench_steps.hpp"

#include "particles/text/output.hpp"
#include "programs/measure/step_timer.hpp"

#include <cstdio>
#include <memory>

namespace command {
namespace {

// Times are ns per particle; 0 where no step was of that kind.
struct Row {
  double skin = 0, mean = 0, searched = 0, filtered = 0, search_share = 0, candidates = 0;
  size_t pairs = 0;
};

// Steps of a kind are alike, so their median stands for each of them: a slow moment of the machine does not count.
Row row_of(measure::StepTimer &timer, double skin, size_t count) {
  const double ns = 1e9 / static_cast<double>(count);
  const auto searches = static_cast<double>(timer.searched().size());
  const auto filters = static_cast<double>(timer.filtered().size());
  Row row;
  row.skin = skin;
  if (searches > 0) row.searched = measure::median(timer.searched()) * ns;
  if (filters > 0) row.filtered = measure::median(timer.filtered()) * ns;
  row.search_share = searches / (searches + filters);
  row.mean = row.search_share * row.searched + (1 - row.search_share) * row.filtered;
  row.candidates = static_cast<double>(timer.grid().get_stats().stored_count) / static_cast<double>(count);
  row.pairs = timer.pairs();
  return row;
}

void write_csv(const std::string &path, const StepOptions &options, const std::vector<Row> &rows) {
  particles::Output out(path);
  out << "skin,displacement,steps,ns_per_particle_and_step,search_share,ns_searched,ns_filtered,"
         "stored_per_particle,pairs\n";
  for (const Row &row : rows) {
    out << row.skin << ',' << options.displacement << ',' << options.steps << ',' << row.mean << ',' << row.search_share
        << ',' << row.searched << ',' << row.filtered << ',' << row.candidates << ',' << row.pairs << '\n';
  }
  out.close();
}

}  // namespace

void bench_steps(const StepOptions &options, hg_grid_def def, const particles::ParticleSet &particles,
                 const std::string &name, const std::string &csv) {
  measure::Flight flight(particles, options.displacement);
  std::vector<std::unique_ptr<measure::StepTimer>> timers;
  for (const double skin : options.skins) {
    def.skin = skin;
    timers.push_back(std::make_unique<measure::StepTimer>(def, particles));
  }
  // All skins take turns at each step, so that a slow moment of the machine touches all alike.
  for (int step = 0; step < options.steps; step++) {
    flight.step();
    for (auto &timer : timers) timer->step(flight.particles());
  }
  std::printf("%s: %zu particles, %d steps of up to %g; hg_move and hg_query_pairs, ns per particle and step\n\n",
              name.c_str(), particles.count(), options.steps, options.displacement);
  std::printf("%10s %10s %12s %12s %12s %12s %10s\n", "skin", "mean", "searched", "if searched", "if filtered",
              "stored", "pairs");
  std::vector<Row> rows;
  for (size_t k = 0; k < timers.size(); k++) {
    rows.push_back(row_of(*timers[k], options.skins[k], particles.count()));
    const Row &row = rows.back();
    std::printf("%10g %10.1f %11.0f%% %12.1f %12.1f %12.2f %10zu\n", row.skin, row.mean, 100 * row.search_share,
                row.searched, row.filtered, row.candidates, row.pairs);
  }
  if (!csv.empty()) write_csv(csv, options, rows);
}

}  // namespace command
