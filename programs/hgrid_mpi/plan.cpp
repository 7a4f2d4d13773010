// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid-mpi plan: what ranks that are not there would hold, send and take for a step.
#include "particles/error.hpp"
#include "particles/text/output.hpp"
#include "programs/hgrid/grid_options.hpp"
#include "programs/hgrid/particle_options.hpp"
#include "programs/hgrid_mpi/command.hpp"
#include "programs/ranks/prediction.hpp"
#include "programs/ranks/repeated.hpp"

#include <hgrid/hgrid.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace command {
namespace {

using ranks::Exchange;
using ranks::Load;
using ranks::Part;

struct PlanOptions {
  ParticleOptions particles;
  GridOptions grid;
  std::vector<int> ranks;
  bool weak = false, weigh_pairs = false;
  double skin = 0;
  ranks::Assumptions assumed;
};

// The system of a plan, with what one rank that has all of it finds.
struct System {
  particles::ParticleSet set;
  hg_grid_def def;
  std::vector<double> pairs_of;  // [count]: those of which the particle is the smaller
};

// A table is filled row by row, with one for each halo.
struct Summary {
  double ghosts = 0;  // per particle, of all ranks
  double owned_most = 0, messages = 0, messages_most = 0, bytes = 0, bytes_most = 0, pairs_uneven = 1, seconds = 0;
};

System load_system(const PlanOptions &options) {
  System system{load_particles(options.particles), {}, {}};
  hgrid::Grid grid = filled_grid(options.grid, system.set, options.particles.file);
  system.def = grid_def(options.grid, system.set, {});
  system.def.skin = options.skin;
  system.pairs_of.assign(system.set.count(), 0);
  const std::vector<double> &radii = system.set.radii;
  const auto base = static_cast<size_t>(options.grid.index_base);
  for (const hg_pair &pair : grid.query_pairs()) {
    const size_t a = static_cast<size_t>(pair.a) - base, b = static_cast<size_t>(pair.b) - base;
    system.pairs_of[radii[b] < radii[a] ? b : a]++;
  }
  return system;
}

Summary summary_of(const std::vector<Load> &loads, const ranks::Machine &machine, const ranks::Assumptions &assumed) {
  Summary sum;
  double owned = 0, ghosts = 0, pairs = 0, pairs_most = 0;
  const auto count = static_cast<double>(loads.size());
  for (const Load &load : loads) {
    const double messages = static_cast<double>(load.exchange.send_ranks), bytes = bytes_per_step(load, assumed);
    owned += static_cast<double>(load.exchange.owned);
    ghosts += static_cast<double>(load.exchange.ghosts);
    pairs += load.pairs;
    pairs_most = std::max(pairs_most, load.pairs);
    sum.messages += messages / count;
    sum.messages_most = std::max(sum.messages_most, messages);
    sum.bytes += bytes / count;
    sum.bytes_most = std::max(sum.bytes_most, bytes);
    sum.owned_most = std::max(sum.owned_most, static_cast<double>(load.exchange.owned));
    sum.seconds = std::max(sum.seconds, step_seconds(load, machine, assumed));
  }
  sum.ghosts = owned > 0 ? ghosts / owned : 0;
  sum.pairs_uneven = pairs > 0 ? pairs_most * count / pairs : 1;
  return sum;
}

double sum_of(const std::vector<double> &numbers) {
  double sum = 0;
  for (const double number : numbers) sum += number;
  return sum;
}

// About as many size classes as the whole has.
double boxes_of(const System &system) {
  const auto [low, high] = std::minmax_element(system.set.radii.begin(), system.set.radii.end());
  return system.set.count() == 0 || *low <= 0 ? 1 : 1 + std::floor(std::log2(*high / *low));
}

// Loads of all ranks with the ghosts of the rule, then with those of a halo of one width.
std::vector<std::vector<Load>> loads_of(const PlanOptions &options, const System &system, int rank_count) {
  std::vector<double> weights(system.set.count(), 1.0);
  for (size_t k = 0; k < weights.size() && options.weigh_pairs; k++) weights[k] += 2 * system.pairs_of[k];
  const std::vector<int32_t> owners = ranks::bisect(system.set, weights, rank_count);
  std::vector<double> pairs(static_cast<size_t>(rank_count), 0);
  for (size_t k = 0; k < owners.size(); k++) pairs[static_cast<size_t>(owners[k])] += system.pairs_of[k];
  const hgrid::mpi::ReachRule rule(system.def);
  std::vector<std::vector<Load>> loads;
  const std::vector<Part> parts = ranks::parts_of(system.set, owners, rank_count);
  for (const std::vector<Part> &seen : {parts, ranks::with_largest_radius(parts)}) {
    loads.emplace_back();
    for (const Exchange &exchange : exchanges_of(rule, seen)) {
      loads.back().push_back({exchange, pairs[loads.back().size()]});
    }
  }
  return loads;
}

int side_of(int rank_count, int dimension) {
  const int side = static_cast<int>(std::lround(std::pow(rank_count, 1.0 / dimension)));
  if (std::lround(std::pow(side, dimension)) != rank_count) {
    throw CLI::ValidationError("--weak", std::to_string(rank_count) + " ranks are no cube (in 2D no square) of them");
  }
  return side;
}

std::vector<std::vector<Load>> repeated_loads(const PlanOptions &options, const System &system, int rank_count) {
  const int side = side_of(rank_count, system.set.dimension);
  for (int axis = 0; axis < system.set.dimension; axis++) {
    if (system.def.periodic[axis] == 0 || system.set.is_tilted()) {
      throw particles::Error(options.particles.file, 0,
                             "a cell that is repeated is periodic along all axes, not tilted");
    }
  }
  const std::vector<Part> one = {{system.set.centers, system.set.radii}};
  std::vector<std::vector<Load>> loads;
  for (const std::vector<Part> &seen : {one, ranks::with_largest_radius(one)}) {
    loads.push_back({{ranks::repeat(system.def, seen[0], side).exchange, sum_of(system.pairs_of)}});
  }
  return loads;
}

void write_head(particles::Output &out, const PlanOptions &options) {
  out << "Assumed:";
  for (const ranks::AssumptionRow &row : ranks::assumption_rows()) {
    out << ' ' << row.option << ' ' << options.assumed.*row.value;
  }
  out << "\n\n| ranks | owned, most | pairs, most over mean | halo | ghosts per particle | neighbours, mean | most | "
         "kB "
         "a step, mean | most | ms a step | efficiency |\n|---|---|---|---|---|---|---|---|---|---|---|\n";
}

std::string text_of(double number, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, number);
  return text;
}

void write_rows(particles::Output &out, const PlanOptions &options, const System &system, int rank_count) {
  const auto all = options.weak ? repeated_loads(options, system, rank_count) : loads_of(options, system, rank_count);
  const ranks::Machine machine{rank_count, system.set.dimension, boxes_of(system)};
  const double share = options.weak ? 1 : rank_count;
  const double serial =
      ranks::serial_seconds(static_cast<double>(system.set.count()), sum_of(system.pairs_of), options.assumed);
  for (size_t halo = 0; halo < all.size(); halo++) {
    const Summary sum = summary_of(all[halo], machine, options.assumed);
    out << "| " << static_cast<size_t>(rank_count) << " | " << text_of(sum.owned_most, 0) << " | "
        << text_of(sum.pairs_uneven, 2) << " | " << (halo == 0 ? "by size" : "one width") << " | "
        << text_of(sum.ghosts, 3) << " | " << text_of(sum.messages, 1) << " | " << text_of(sum.messages_most, 0)
        << " | " << text_of(1e-3 * sum.bytes, 1) << " | " << text_of(1e-3 * sum.bytes_most, 1) << " | "
        << text_of(1e3 * sum.seconds, 3) << " | " << text_of(100 * serial / share / sum.seconds, 0) << " % |\n";
  }
}

void run(const PlanOptions &options) {
  const System system = load_system(options);
  for (const int rank_count : options.ranks) {
    if (rank_count < 1) throw CLI::ValidationError("--ranks", std::to_string(rank_count) + " is below 1");
    if (options.weak) side_of(rank_count, system.set.dimension);
  }
  for (const ranks::AssumptionRow &row : ranks::assumption_rows()) {
    if (!(options.assumed.*row.value > 0)) throw CLI::ValidationError(row.option, "is not above 0");
  }
  particles::Output out("-");
  write_head(out, options);
  for (const int rank_count : options.ranks) write_rows(out, options, system, rank_count);
  out.close();
}

}  // namespace

void add_plan(CLI::App &parent) {
  auto options = std::make_shared<PlanOptions>();
  CLI::App &command =
      *parent.add_subcommand("plan", "Tell on one process what a step would cost on many ranks, and why");
  add_particle_options(command, options->particles);
  add_grid_options(command, options->grid);
  command.add_option("--ranks", options->ranks, "Numbers of ranks, with commas")->delimiter(',')->required();
  command.add_flag("--weak", options->weak,
                   "Each rank has a copy of FILE, a periodic cell, beside those of others; ranks are cubes of numbers");
  command.add_flag("--weigh-pairs", options->weigh_pairs,
                   "Particles weigh 1 + 2 for each pair with a larger one, as in hg_mpi_balance; else 1");
  command.add_option("--skin", options->skin, "Of the grid and of ghosts, in the file's unit")->capture_default_str();
  for (const ranks::AssumptionRow &row : ranks::assumption_rows()) {
    command.add_option(row.option, options->assumed.*row.value, row.meaning)
        ->capture_default_str()
        ->group("Assumptions");
  }
  command.footer(
      "Particles are dealt out by bisection and ghosts chosen by the rule of libhgrid_mpi; beside it a halo of one\n"
      "width, which counts every particle as large as the largest. Times are those of a model, of the slowest rank,\n"
      "with nothing overlapped; efficiency: the work on one rank over that, per rank.\n"
      "Examples:\n"
      "  hgrid-mpi plan packing.csv --ranks 8,64,512,4096\n"
      "  hgrid-mpi plan cell.csv --weak --ranks 64,512,4096");
  command.callback([options] { run(*options); });
}

}  // namespace command
