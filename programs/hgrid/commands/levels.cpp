// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid levels: the levels chosen for a particle file, what they cost, and why.
#include "particles/text/formatted.hpp"
#include "particles/text/output.hpp"
#include "programs/hgrid/command.hpp"
#include "programs/hgrid/grid_options.hpp"
#include "programs/hgrid/particle_options.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <string>

namespace command {
namespace {

using particles::formatted;

struct LevelsOptions {
  ParticleOptions particles;
  GridOptions grid;
  bool csv = false;
  bool costs = false;
};

void print_sizes(particles::Output &out, const particles::ParticleSet &particles) {
  out << formatted("particles   %zu in %d dimensions\n", particles.count(), particles.dimension);
  if (particles.count() > 0) {
    const auto [smallest, largest] = std::minmax_element(particles.radii.begin(), particles.radii.end());
    out << formatted("radii       %.6g to %.6g", *smallest, *largest);
    if (*smallest > 0) out << formatted(", size ratio %.6g", *largest / *smallest);
    out << '\n';
  }
  if (!particles.has_box) {
    out << "box         none, all axes open\n\n";
    return;
  }
  out << "box        ";
  for (int axis = 0; axis < particles.dimension; axis++)
    out << formatted(" %.6g..%.6g%s", particles.box_min[axis], particles.box_max[axis],
                     particles.periodic[axis] ? " (periodic)" : "");
  const double *tilt = particles.tilt;
  if (particles.is_tilted()) out << formatted(", tilt %.6g %.6g %.6g", tilt[0], tilt[1], tilt[2]);
  out << "\n\n";
}

void print_levels(particles::Output &out, hgrid::View<hg_level> levels) {
  out << "  level     cell size  largest radius   particles  particles per cell\n";
  int number = 0;
  for (const hg_level &level : levels)
    out << formatted("  %5d  %12.6g  %14.6g  %10lld  %18.4g\n", ++number, level.cell_size, level.largest_radius,
                     static_cast<long long>(level.particle_count), level.occupancy);
}

void print_costs(particles::Output &out, hgrid::View<hg_level_cost> costs, size_t chosen, bool eq_7) {
  if (costs.empty()) {
    out << "\nThe cell sizes were given: no other levels were looked at.\n";
    return;
  }
  out << formatted("\n  levels L  particles per cell m  %14s\n", eq_7 ? "cost L (m + K)" : "cost");
  for (const hg_level_cost &cost : costs) {
    if (cost.reachable == 0)
      out << formatted("  %8d  cannot be reached with these sizes\n", cost.level_count);
    else
      out << formatted("  %8d  %20.4g  %14.6g%s\n", cost.level_count, cost.occupancy, cost.cost,
                       static_cast<size_t>(cost.level_count) == chosen ? "  <- chosen" : "");
  }
  out << "Cost: work for one particle, in units of testing one pair";
  out << (eq_7 ? ", after Eq. 7 of the paper.\n"
               : ": tests, and the prices (hgrid calibrate) of the levels\nand of the rows of finer levels looked at, "
                 "expected from the sizes and a sample of the places.\n");
}

void print_statistics(particles::Output &out, const hg_grid_stats &stats) {
  out << formatted("\nstored      %lld cells in %lld rows\n", static_cast<long long>(stats.cell_count),
                   static_cast<long long>(stats.row_count));
  if (stats.particle_count > 0)
    out << formatted("memory      %.1f bytes for each particle\n",
                     static_cast<double>(stats.byte_count) / static_cast<double>(stats.particle_count));
}

void write_levels_csv(particles::Output &out, hgrid::View<hg_level> levels) {
  out << "level,cell_size,largest_radius,particle_count,occupancy\n";
  int number = 0;
  for (const hg_level &level : levels)
    out << ++number << ',' << level.cell_size << ',' << level.largest_radius << ',' << level.particle_count << ','
        << level.occupancy << '\n';
}

void write_costs_csv(particles::Output &out, hgrid::View<hg_level_cost> costs, size_t chosen) {
  out << "level_count,reachable,occupancy,cost,chosen\n";
  for (const hg_level_cost &cost : costs)
    out << cost.level_count << ',' << cost.reachable << ',' << cost.occupancy << ',' << cost.cost << ','
        << (static_cast<size_t>(cost.level_count) == chosen ? 1 : 0) << '\n';
}

void run(const LevelsOptions &options) {
  const particles::ParticleSet particles = load_particles(options.particles);
  hgrid::Grid grid = filled_grid(options.grid, particles, options.particles.file);
  const hgrid::View<hg_level> levels = grid.query_levels();
  const hgrid::View<hg_level_cost> costs = grid.query_level_costs();
  particles::Output out("-");
  if (options.csv && options.costs) {
    write_costs_csv(out, costs, levels.size());
  } else if (options.csv) {
    write_levels_csv(out, levels);
  } else {
    print_sizes(out, particles);
    print_levels(out, levels);
    print_costs(out, costs, levels.size(), options.grid.levels == "paper" || options.grid.cell_overhead >= 0);
    print_statistics(out, grid.get_stats());
  }
  out.close();
}

}  // namespace

void add_levels(CLI::App &parent) {
  auto options = std::make_shared<LevelsOptions>();
  CLI::App &command = *parent.add_subcommand("levels", "Explain the levels chosen for a particle file");
  add_particle_options(command, options->particles);
  add_grid_options(command, options->grid);
  auto *csv = command.add_flag("--csv", options->csv, "Only the table of levels, as CSV");
  command.add_flag("--costs", options->costs, "With --csv: the table of costs instead")->needs(csv);
  command.footer(
      "Level 1 holds the smallest particles. A particle lies on the first level whose cells are as large as its\n"
      "diameter plus the margin (its range with --max-range).\n"
      "Examples:\n"
      "  hgrid levels packing.csv\n"
      "  hgrid levels packing.csv --levels paper --level-count 3\n"
      "  hgrid levels packing.csv --csv --costs");
  command.callback([options] { run(*options); });
}

}  // namespace command
